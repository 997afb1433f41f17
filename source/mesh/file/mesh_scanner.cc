#include <stickslip/mesh/file/mesh_scanner.h>

#include <stickslip/base/text_encoding.h>
#include <stickslip/mesh/file/mesh_file.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace stickslip
{
  namespace
  {
    bool
    is_blank(const char letter)
    {
      return letter == ' ' || letter == '\n' || letter == '\t' ||
             letter == '\r' || letter == '\f' || letter == '\v';
    }
  } // namespace



  std::string
  quoted_word(const std::string_view word)
  {
    std::string text;
    for (const char letter : word.substr(0, 30))
      text += (static_cast<unsigned char>(letter) < 32 || letter == 127)
                ? '?'
                : letter;
    return "'" + text + (word.size() > 30 ? "..." : "") + "'";
  }



  bool
  parse_number(const std::string_view word, double &value)
  {
    std::string_view digits = word;
    if (!digits.empty() && digits[0] == '+')
      digits.remove_prefix(1);
    char       buffer[64];
    const auto exponent = digits.find_first_of("dD");
    if (exponent != std::string_view::npos && digits.size() < sizeof(buffer))
      {
        std::copy(digits.begin(), digits.end(), buffer);
        buffer[exponent] = 'e';
        digits           = std::string_view(buffer, digits.size());
      }
    const char *const end    = digits.data() + digits.size();
    const auto        result = std::from_chars(digits.data(), end, value);
    if (result.ptr != end || digits.empty())
      return false;
    // Numbers like 1e-400 are zero.
    if (result.ec == std::errc::result_out_of_range)
      value = (digits.find("e-") != std::string_view::npos ||
               digits.find("E-") != std::string_view::npos)
                ? 0.
                : HUGE_VAL;
    else if (result.ec != std::errc())
      return false;
    return std::isfinite(value);
  }



  bool
  parse_integer(const std::string_view word, long &value)
  {
    std::string_view digits = word;
    if (!digits.empty() && digits[0] == '+')
      digits.remove_prefix(1);
    const char *const end    = digits.data() + digits.size();
    const auto        result = std::from_chars(digits.data(), end, value);
    return result.ec == std::errc() && result.ptr == end && !digits.empty();
  }



  bool
  MeshScanner::is_at_end()
  {
    while (position < text.size() && is_blank(text[position]))
      ++position;
    return position == text.size();
  }



  bool
  MeshScanner::is_at_end_of_line()
  {
    while (position < text.size() && text[position] != '\n' &&
           is_blank(text[position]))
      ++position;
    return position == text.size() || text[position] == '\n';
  }



  std::string_view
  MeshScanner::word(const std::string &what)
  {
    if (is_at_end())
      {
        last = text.size();
        fail("the file ends where " + what + " is expected");
      }
    last = position;
    while (position < text.size() && !is_blank(text[position]))
      ++position;
    return text.substr(last, position - last);
  }



  void
  MeshScanner::expect(const std::string &expected)
  {
    const std::string_view found = word(expected);
    if (found != expected)
      fail("found " + quoted_word(found) + " where " + expected +
           " is expected");
  }



  long
  MeshScanner::integer(const std::string &what)
  {
    const std::string_view found = word(what);
    long                   value = 0;
    if (!parse_integer(found, value))
      fail("found " + quoted_word(found) + " where " + what +
           ", a whole number, is expected");
    return value;
  }



  std::size_t
  MeshScanner::count(const std::string &what, const std::size_t n_bytes)
  {
    const long value = integer(what);
    if (value < 0)
      fail(what + " is " + std::to_string(value) + ", but cannot be negative");
    check_count(what, value, n_bytes);
    return value;
  }



  void
  MeshScanner::check_count(const std::string &what,
                           const double       number,
                           const std::size_t  n_bytes) const
  {
    if (number * n_bytes > 1. + bytes_left())
      fail(what + " is " + std::to_string(static_cast<long long>(number)) +
           ", more than the rest of the file can hold: it is incomplete or "
           "the number is wrong");
  }



  double
  MeshScanner::number(const std::string &what)
  {
    const std::string_view found = word(what);
    double                 value = 0.;
    if (!parse_number(found, value))
      fail("found " + quoted_word(found) + " where " + what +
           ", a finite number, is expected");
    return value;
  }



  std::string_view
  MeshScanner::rest_of_line()
  {
    const std::size_t begin = position;
    const std::size_t end   = std::min(text.find('\n', begin), text.size());
    last                    = begin;
    position                = std::min(end + 1, text.size());
    return text.substr(begin, end - begin);
  }



  bool
  MeshScanner::skip_behind(const std::string_view mark)
  {
    const std::size_t found = text.find(mark, position);
    if (found == std::string_view::npos)
      return false;
    last     = found;
    position = found + mark.size();
    return true;
  }



  const char *
  MeshScanner::bytes(const std::size_t n, const std::string &what)
  {
    last = position;
    if (bytes_left() < n)
      fail("the file ends where " + what + " is expected");
    position += n;
    return text.data() + last;
  }



  std::size_t
  MeshScanner::line() const
  {
    return 1 + std::count(text.begin(), text.begin() + last, '\n');
  }



  void
  MeshScanner::fail(const std::string &message) const
  {
    throw MeshFileError(message, line());
  }



  std::string
  plain_text(const std::string &contents)
  {
    if (is_utf16(contents))
      throw MeshFileError(
        "it is encoded as UTF-16. Save it as UTF-8 (iconv -f "
        "UTF-16 -t UTF-8)");
    const std::size_t begin =
      contents.size() - without_byte_order_mark(contents).size();

    std::string text;
    text.reserve(contents.size() - begin);
    std::size_t line = 1;
    for (std::size_t i = begin; i < contents.size(); ++i)
      if (contents[i] == '\0')
        throw MeshFileError("found a zero byte: it is no text file", line);
      else if (contents[i] != '\r')
        {
          text += contents[i];
          line += contents[i] == '\n';
        }
      else if (i + 1 == contents.size() || contents[i + 1] != '\n')
        {
          text += '\n';
          ++line;
        }
    return is_utf8(text) ? text : utf8_of_latin1(text);
  }
} // namespace stickslip
