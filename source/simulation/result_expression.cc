#include <stickslip/simulation/result_expression.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/parsed_expression.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/point.h>

#include <cctype>
#include <cmath>
#include <iomanip>
#include <limits>
#include <regex>
#include <sstream>

namespace stickslip
{
  namespace
  {
    bool
    is_of_a_name(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
             c == '.';
    }



    /// The longest of @p names at @p position of @p text that ends there as a
    /// word; empty: none.
    std::string
    name_at(const std::string              &text,
            const std::size_t               position,
            const std::vector<std::string> &names)
    {
      std::string longest;
      for (const std::string &name : names)
        if (name.size() > longest.size() &&
            text.compare(position, name.size(), name) == 0 &&
            (position + name.size() == text.size() ||
             !is_of_a_name(text[position + name.size()])))
          longest = name;
      return longest;
    }



    /// "(1.5)", with every digit.
    std::string
    number_in_brackets(const double value)
    {
      std::ostringstream text;
      text << '(' << std::setprecision(17) << value << ')';
      return text.str();
    }
  } // namespace



  ResultExpression::ResultExpression(const std::string              &text,
                                     const std::vector<std::string> &known,
                                     const std::string              &path)
    : path(path)
    , texts(1)
  {
    for (std::size_t i = 0; i < text.size();)
      {
        const bool        is_start = i == 0 || !is_of_a_name(text[i - 1]);
        const std::string name     = is_start ? name_at(text, i, known) : "";
        if (name.empty())
          texts.back() += text[i++];
        else
          {
            used.push_back(name);
            texts.emplace_back();
            i += name.size();
          }
      }
    refuse_unknown_names(text, known);
    refuse_functions_of_one(text);
    value([](const std::string &) { return 1.; });
  }



  void
  ResultExpression::refuse_unknown_names(
    const std::string              &text,
    const std::vector<std::string> &known) const
  {
    const auto refuse = [&](const std::string &name) {
      throw UserError("'" + path + "': there is no result '" + name + "'." +
                      did_you_mean(name, known) +
                      " Known: " + quoted_list(known) + ".");
    };
    if (used.empty() && text.find_first_of("+-*/^()<>=!&|?,") == text.npos)
      refuse(text);
    for (const std::string &part : texts)
      for (std::size_t i = 0; i < part.size(); ++i)
        if (is_of_a_name(part[i]))
          {
            std::size_t end = i;
            while (end < part.size() && is_of_a_name(part[end]))
              ++end;
            const std::string word = part.substr(i, end - i);
            const std::size_t next = part.find_first_not_of(' ', end);
            const bool        is_function =
              next != std::string::npos && part[next] == '(';
            const bool is_number =
              std::isdigit(static_cast<unsigned char>(word[0])) != 0 ||
              word[0] == '.';
            if (!is_function && !is_number && word != "pi")
              refuse(word);
            i = end;
          }
  }



  void
  ResultExpression::refuse_functions_of_one(const std::string &text) const
  {
    static const std::regex function(R"(\b(max|min|sum|avg) *\()");
    for (std::sregex_iterator f(text.begin(), text.end(), function), end;
         f != end;
         ++f)
      {
        const std::size_t begin = f->position() + f->length();
        std::size_t       i     = begin;
        for (unsigned int depth = 1; i < text.size(); ++i)
          {
            depth += text[i] == '(' ? 1 : 0;
            depth -= text[i] == ')' ? 1 : 0;
            if (depth == 0 || (depth == 1 && text[i] == ','))
              break;
          }
        if (i < text.size() && text[i] == ')' && i > begin)
          throw UserError("'" + path + "': '" +
                          text.substr(f->position(), i + 1 - f->position()) +
                          "' is of one number, that of the last step. Give '" +
                          text.substr(begin, i - begin) +
                          "' alone; 'Value = maximum' or 'minimum' looks at "
                          "all steps.");
      }
  }



  double
  ResultExpression::value(
    const std::function<double(const std::string &)> &result) const
  {
    const bool is_name =
      used.size() == 1 &&
      (texts[0] + texts[1]).find_first_not_of(' ') == std::string::npos;
    if (is_name)
      return result(used[0]);
    std::string text = texts[0];
    for (unsigned int i = 0; i < used.size(); ++i)
      {
        const double number = result(used[i]);
        if (!std::isfinite(number))
          return std::numeric_limits<double>::quiet_NaN();
        text += number_in_brackets(number) + texts[i + 1];
      }
    return parse_expressions<2>("x,y", {text}, path)->value(Point<2>());
  }
} // namespace stickslip
