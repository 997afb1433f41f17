#ifndef stickslip_base_parsed_expression_h
#define stickslip_base_parsed_expression_h

#include <deal.II/base/function_parser.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * A muparser function: @p variables names n coordinates and possibly one more,
   * which is passed with set_time() ("x,y,z,id"). `pi` is known. Throws
   * UserError with muparser's words that blames @p parameter_path.
   */
  template <int n>
  std::unique_ptr<FunctionParser<n>>
  parse_expressions(const std::string              &variables,
                    const std::vector<std::string> &expressions,
                    const std::string              &parameter_path);

  /**
   * The value of an expression of @p constants, `pi` and muparser's functions.
   * Throws UserError that begins with @p place.
   */
  double
  evaluate_expression(const std::string                   &expression,
                      const std::map<std::string, double> &constants,
                      const std::string                   &place);
} // namespace stickslip

#endif
