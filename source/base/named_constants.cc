#include <stickslip/base/named_constants.h>
#include <stickslip/base/parsed_expression.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <vector>

namespace stickslip
{
  namespace
  {
    bool
    is_identifier(const std::string &name)
    {
      const auto is_letter = [](const unsigned char c) {
        return std::isalnum(c) || c == '_';
      };
      return !name.empty() &&
             !std::isdigit(static_cast<unsigned char>(name[0])) &&
             std::all_of(name.begin(), name.end(), is_letter);
    }



    /// All digits; a whole number without an exponent, so that it may count.
    std::string
    text_of(const double value)
    {
      std::array<char, 40> buffer;
      if (value == std::floor(value) && std::abs(value) < 1e15)
        {
          std::snprintf(buffer.data(), buffer.size(), "%.0f", value);
          return buffer.data();
        }
      const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
      return std::string(buffer.data(), end.ptr);
    }



    /// -2 in `-2^2` would be squared before its sign is seen.
    bool
    is_base_of_power(const std::string &text, std::size_t after)
    {
      while (after < text.size() && text[after] == ' ')
        ++after;
      return after < text.size() && text[after] == '^';
    }
  } // namespace



  bool
  is_about_constants(const ParameterStatement &statement)
  {
    return !statement.path.empty() &&
           statement.path[0] == NamedConstants::section_name;
  }



  NamedConstants::NamedConstants(const std::vector<ParameterStatement> &entries)
  {
    for (const ParameterStatement &entry : entries)
      if (is_about_constants(entry))
        {
          const std::string place =
            entry.location() + ": '" + entry.full_name() + "'";
          if (entry.path.size() > 1)
            throw UserError(place + ": Constants has no subsections.");
          if (!is_identifier(entry.name))
            throw UserError(place +
                            ": the name of a constant has to be made of "
                            "letters, digits and '_'.");
          const double value = evaluate_expression(entry.value, values, place);
          if (!std::isfinite(value))
            throw UserError(place + " is '" + entry.value +
                            "', which is not a finite number.");
          values[entry.name] = value;
        }
  }



  void
  NamedConstants::declare_placeholder(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(section_name);
    prm.declare_entry("<constant>",
                      "",
                      dealii::Patterns::Anything(),
                      "A number, or an expression of the constants above it, "
                      "with pi. '{constant}', or an expression between "
                      "braces, '{2 * constant}', stands for it in the value "
                      "of any parameter.");
    prm.leave_subsection();
  }



  std::string
  NamedConstants::inserted_in(const std::string &text,
                              const std::string &place) const
  {
    std::string result;
    std::size_t position = 0;
    while (position < text.size())
      {
        const std::size_t begin = text.find_first_of("{}", position);
        result += text.substr(position, begin - position);
        if (begin == std::string::npos)
          break;
        const std::size_t end = text.find_first_of("{}", begin + 1);
        if (text[begin] == '}' || end == std::string::npos || text[end] == '{')
          throw UserError(place + " is '" + text +
                          "': its braces do not match. '{name}' stands for a "
                          "number of the section Constants.");
        const double value =
          evaluate_expression(text.substr(begin + 1, end - begin - 1),
                              values,
                              place);
        if (!std::isfinite(value))
          throw UserError(place + " is '" + text +
                          "', of which the part between braces is not a "
                          "finite number.");
        result += (value < 0. && is_base_of_power(text, end + 1))
                    ? "(" + text_of(value) + ")"
                    : text_of(value);
        position = end + 1;
      }
    return result;
  }
} // namespace stickslip
