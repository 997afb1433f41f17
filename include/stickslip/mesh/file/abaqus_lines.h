#ifndef stickslip_mesh_file_abaqus_lines_h
#define stickslip_mesh_file_abaqus_lines_h

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip
{
  std::string
  upper_case(const std::string_view text);

  /// "*ELEMENT, TYPE=C3D8, ELSET=a": keywords and options have no meaning of
  /// case and blanks.
  struct AbaqusKeyword
  {
    std::string                        name;    ///< upper case, without blanks
    std::map<std::string, std::string> options; ///< upper case: as written

    bool
    has(const std::string &option) const
    {
      return options.count(option) > 0;
    }

    /// Empty if the option is not given.
    std::string
    value(const std::string &option) const
    {
      const auto found = options.find(option);
      return found == options.end() ? "" : found->second;
    }
  };

  /**
   * The lines of an Abaqus file, keyword lines joined with those that continue
   * them, without comments and empty lines.
   */
  class AbaqusLines
  {
  public:
    explicit AbaqusLines(const std::string_view text)
      : text(text)
    {}

    /// Goes to the next line. False at the end.
    bool
    next();

    bool
    is_keyword() const
    {
      return is_at_keyword;
    }

    const AbaqusKeyword &
    keyword() const
    {
      return present_keyword;
    }

    /// Of a data line, without blanks around them.
    const std::vector<std::string_view> &
    entries() const
    {
      return present_entries;
    }

    /// True if a comma ends the line: the next one may continue it.
    bool
    is_continued() const
    {
      return ends_with_comma;
    }

    std::size_t
    line() const
    {
      return line_number;
    }

    [[noreturn]] void
    fail(const std::string &message) const;

    /// Entry @p index of the data line as a number, 0 if it is empty or not
    /// there.
    double
    number(const unsigned int index, const std::string &what) const;

    long
    integer(const unsigned int index, const std::string &what) const;

  private:
    bool
    next_raw_line(std::string_view &line);

    void
    read_keyword(std::string_view line);

    void
    split(std::string_view line);

    std::string_view              text;
    std::size_t                   position    = 0;
    std::size_t                   line_number = 0;
    AbaqusKeyword                 present_keyword;
    std::vector<std::string_view> present_entries;
    bool                          is_at_keyword   = false;
    bool                          ends_with_comma = false;
  };
} // namespace stickslip

#endif
