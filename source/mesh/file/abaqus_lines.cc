#include <stickslip/mesh/file/abaqus_lines.h>

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/file/mesh_scanner.h>

#include <algorithm>
#include <cctype>

namespace stickslip
{
  namespace
  {
    std::string_view
    without_blanks_around(const std::string_view text)
    {
      const std::size_t first = text.find_first_not_of(" \t\f\v");
      return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first,
                             text.find_last_not_of(" \t\f\v") - first + 1);
    }



    std::string
    keyword_letters(const std::string_view text)
    {
      std::string result = upper_case(text);
      result.erase(std::remove_if(result.begin(),
                                  result.end(),
                                  [](const unsigned char c) {
                                    return std::isspace(c);
                                  }),
                   result.end());
      return result;
    }
  } // namespace



  std::string
  upper_case(const std::string_view text)
  {
    std::string result(text);
    std::transform(result.begin(),
                   result.end(),
                   result.begin(),
                   [](const unsigned char c) { return std::toupper(c); });
    return result;
  }



  bool
  AbaqusLines::next_raw_line(std::string_view &line)
  {
    while (position < text.size())
      {
        const std::size_t end =
          std::min(text.find('\n', position), text.size());
        line     = without_blanks_around(text.substr(position, end - position));
        position = end + 1;
        ++line_number;
        if (!line.empty() && line.substr(0, 2) != "**")
          return true;
      }
    return false;
  }



  bool
  AbaqusLines::next()
  {
    std::string_view line;
    if (!next_raw_line(line))
      return false;
    is_at_keyword = (line[0] == '*');
    if (is_at_keyword)
      read_keyword(line);
    else
      split(line);
    return true;
  }



  void
  AbaqusLines::read_keyword(std::string_view line)
  {
    std::string all(line);
    while (line.back() == ',' && next_raw_line(line))
      all += line;

    split(all);
    present_keyword.name = keyword_letters(present_entries[0].substr(1));
    present_keyword.options.clear();
    for (unsigned int i = 1; i < present_entries.size(); ++i)
      {
        const std::string_view entry = present_entries[i];
        const std::size_t      equal = entry.find('=');
        std::string_view       value =
          equal == std::string_view::npos
                  ? std::string_view()
                  : without_blanks_around(entry.substr(equal + 1));
        if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
          value = value.substr(1, value.size() - 2);
        present_keyword.options[keyword_letters(entry.substr(0, equal))] =
          std::string(value);
      }
    present_entries.clear();
  }



  void
  AbaqusLines::split(std::string_view line)
  {
    present_entries.clear();
    ends_with_comma = !line.empty() && line.back() == ',';
    if (ends_with_comma)
      line.remove_suffix(1);
    while (true)
      {
        const std::size_t comma = line.find(',');
        present_entries.push_back(without_blanks_around(line.substr(0, comma)));
        if (comma == std::string_view::npos)
          return;
        line.remove_prefix(comma + 1);
      }
  }



  void
  AbaqusLines::fail(const std::string &message) const
  {
    throw MeshFileError(message, line_number);
  }



  double
  AbaqusLines::number(const unsigned int index, const std::string &what) const
  {
    if (index >= present_entries.size() || present_entries[index].empty())
      return 0.;
    double value = 0.;
    if (!parse_number(present_entries[index], value))
      fail("found " + quoted_word(present_entries[index]) + " where " + what +
           ", a finite number, is expected");
    return value;
  }



  long
  AbaqusLines::integer(const unsigned int index, const std::string &what) const
  {
    long value = 0;
    if (index >= present_entries.size() ||
        !parse_integer(present_entries[index], value))
      fail("found " +
           (index < present_entries.size() ? quoted_word(present_entries[index])
                                           : "the end of the line") +
           " where " + what + ", a whole number, is expected");
    return value;
  }
} // namespace stickslip
