#ifndef stickslip_mesh_file_mesh_scanner_h
#define stickslip_mesh_file_mesh_scanner_h

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace stickslip
{
  /**
   * Walks through the text of a mesh file, word by word. What is not as
   * expected becomes a MeshFileError with the line. The text must outlive the
   * scanner.
   */
  class MeshScanner
  {
  public:
    explicit MeshScanner(const std::string_view text)
      : text(text)
    {}

    /// Skips white space; true if nothing follows.
    bool
    is_at_end();

    /// The next word. @p what is expected, in the message if the text ends.
    std::string_view
    word(const std::string &what);

    /// Passes over the next word, which has to be @p expected.
    void
    expect(const std::string &expected);

    /// The next word as a whole number of at most 18 digits.
    long
    integer(const std::string &what);

    /// The next word as a number of things that follow, each at least
    /// @p n_bytes long: more than the rest of the file has room for is an
    /// error.
    std::size_t
    count(const std::string &what, const std::size_t n_bytes = 2);

    /// Throws unless @p number things of @p n_bytes each fit into the rest.
    void
    check_count(const std::string &what,
                const double       number,
                const std::size_t  n_bytes) const;

    /// The next word as a finite number; Fortran's exponent D is allowed.
    double
    number(const std::string &what);

    /// What is left of the present line, without its end, which is passed.
    std::string_view
    rest_of_line();

    /// True if nothing but blanks follows on the present line.
    bool
    is_at_end_of_line();

    /// Passes over @p mark, to be found from here on; false if it is not there.
    bool
    skip_behind(const std::string_view mark);

    /// The next bytes as a binary value. @p T is trivially copyable.
    template <typename T>
    T
    binary(const std::string &what)
    {
      T value;
      std::memcpy(&value, bytes(sizeof(T), what), sizeof(T));
      return value;
    }

    /// The next @p n bytes, which are passed.
    const char *
    bytes(const std::size_t n, const std::string &what);

    std::size_t
    bytes_left() const
    {
      return text.size() - position;
    }

    /// The line of the word read last, from 1.
    std::size_t
    line() const;

    /// Throws a MeshFileError at the present line.
    [[noreturn]] void
    fail(const std::string &message) const;

  private:
    std::string_view text;
    std::size_t      position = 0;
    std::size_t      last     = 0; ///< where the last word begins
  };

  /// A word of the file as it can be shown in a message: short and printable.
  std::string
  quoted_word(const std::string_view word);

  /// Reads a finite number; false if @p word is none.
  bool
  parse_number(const std::string_view word, double &value);

  /// Reads a whole number of at most 18 digits; false if @p word is none.
  bool
  parse_integer(const std::string_view word, long &value);

  /**
   * The text with lines that end with '\n' alone, without a byte order mark,
   * in UTF-8 (what is not UTF-8 is taken for Latin-1). Throws MeshFileError for
   * UTF-16 and for bytes that no text has.
   */
  std::string
  plain_text(const std::string &contents);
} // namespace stickslip

#endif
