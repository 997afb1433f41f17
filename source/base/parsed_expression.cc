#include <stickslip/base/parsed_expression.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/short_message.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <streambuf>

namespace stickslip
{
  namespace
  {
    /// FunctionParser prints muparser's message on every rank before it throws;
    /// the user shall get ours, once.
    class SilentErrorStream
    {
    public:
      SilentErrorStream()
        : original(std::cerr.rdbuf(discarded.rdbuf()))
      {}

      ~SilentErrorStream()
      {
        std::cerr.rdbuf(original);
      }

    private:
      std::ostringstream discarded;
      std::streambuf    *original;
    };
  } // namespace



  template <int n>
  std::unique_ptr<FunctionParser<n>>
  parse_expressions(const std::string              &variables,
                    const std::vector<std::string> &expressions,
                    const std::string              &parameter_path)
  {
    const std::map<std::string, double> constants = {{"pi", numbers::PI}};
    auto parser = std::make_unique<FunctionParser<n>>(expressions.size());
    try
      {
        const SilentErrorStream silence;
        const bool              has_extra_variable =
          std::count(variables.begin(), variables.end(), ',') == n;
        parser->initialize(variables,
                           expressions,
                           constants,
                           has_extra_variable);
        // muparser finds some mistakes only when it evaluates.
        for (unsigned int c = 0; c < expressions.size(); ++c)
          parser->value(Point<n>(), c);
      }
    catch (const std::exception &exception)
      {
        std::string text;
        for (const std::string &expression : expressions)
          text += (text.empty() ? "" : "; ") + expression;
        throw UserError(parameter_path + ": cannot evaluate '" + text +
                        "' with the variables " + variables + ". " +
                        short_message(exception));
      }
    return parser;
  }



  double
  evaluate_expression(const std::string                   &expression,
                      const std::map<std::string, double> &constants,
                      const std::string                   &place)
  {
    if (expression.find_first_not_of(" \t") == std::string::npos)
      throw UserError(place + ": there is no expression to evaluate.");
    std::map<std::string, double> known = constants;
    known["pi"]                         = numbers::PI;
    try
      {
        const SilentErrorStream silence;
        FunctionParser<1>       parser(1);
        parser.initialize("_", {expression}, known);
        return parser.value(Point<1>());
      }
    catch (const std::exception &exception)
      {
        std::vector<std::string> names;
        for (const auto &constant : constants)
          names.push_back(constant.first);
        throw UserError(place + ": cannot evaluate '" + expression +
                        "' with the constants " + quoted_list(names) + ". " +
                        short_message(exception));
      }
  }



  template std::unique_ptr<FunctionParser<2>>
  parse_expressions<2>(const std::string &,
                       const std::vector<std::string> &,
                       const std::string &);
  template std::unique_ptr<FunctionParser<3>>
  parse_expressions<3>(const std::string &,
                       const std::vector<std::string> &,
                       const std::string &);
} // namespace stickslip
