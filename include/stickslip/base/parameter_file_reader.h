#ifndef stickslip_base_parameter_file_reader_h
#define stickslip_base_parameter_file_reader_h

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * One statement of a parameter file: `set name = value` or, with empty name
   * and value, `subsection`. Also one `--set` of the command line.
   */
  struct ParameterStatement
  {
    std::vector<std::string> path; ///< the enclosing subsections
    std::string              name;
    std::string              value;
    std::string              file; ///< empty for the command line
    unsigned int             line = 0;

    /// "Section/Subsection/Name".
    std::string
    full_name() const;

    /// Where a message about it points to: "case.prm:12" or "--set".
    std::string
    location() const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &path &name &value &file &line;
    }
  };

  /**
   * All statements of a parameter file and of the files that it includes.
   */
  struct ParameterStatements
  {
    std::vector<ParameterStatement> entries;  ///< one per parameter that is set
    std::vector<ParameterStatement> sections; ///< every `subsection`, in order

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &entries &sections;
    }
  };

  /**
   * Reads deal.II's parameter file syntax into statements; see ParameterFile
   * for the syntax. Knows nothing of what the parameters mean. Not collective.
   */
  class ParameterFileReader
  {
  public:
    /**
     * Reads a file and what it includes. Throws UserError, with file and
     * line, for a file that cannot be read and for wrong syntax.
     */
    static ParameterStatements
    read_file(const std::string &file_name);

    /// The same from an opened stream; @p name stands for the file.
    static ParameterStatements
    read_stream(std::istream &input, const std::string &name);

  private:
    struct OpenFile
    {
      std::string  name;
      std::size_t  n_outer_sections; ///< open when the file was included
      std::size_t  n_outer_entries;  ///< set when the file was included
      unsigned int line = 0;         ///< of the statement in work
    };

    void
    open(const std::string &file_name, const std::string &included_at);

    void
    read(std::istream &input, const std::string &file_name);

    /// Ends the innermost open file, whose subsections must all be closed.
    void
    close();

    /// Fails unless the line is UTF-8.
    void
    check_encoding(const std::string &line) const;

    void
    process(const std::string &statement);

    void
    enter_subsection(const std::string &name);

    void
    leave_subsection();

    void
    include(const std::string &file_name);

    void
    set(const std::string &assignment);

    /// Throws a UserError that begins with the place of the present statement.
    [[noreturn]] void
    fail(const std::string &text) const;

    /// A statement at the present place, without name and value.
    ParameterStatement
    statement_here() const;

    ParameterStatements             statements;
    std::vector<ParameterStatement> open_sections;
    std::vector<OpenFile>           open_files;
  };

  /// "Bodies/block" -> {"Bodies", "block"}; "" -> {}.
  std::vector<std::string>
  split_parameter_path(const std::string &path);

  /// {"Bodies", "block"} -> "Bodies/block".
  std::string
  join_parameter_path(const std::vector<std::string> &path);
} // namespace stickslip

#endif
