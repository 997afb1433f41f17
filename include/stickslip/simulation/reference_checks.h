#ifndef stickslip_simulation_reference_checks_h
#define stickslip_simulation_reference_checks_h

#include <stickslip/base/choice.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  enum class ToleranceType
  {
    relative, ///< to the known value
    absolute
  };

  /// A result of the run with its known value: a member of section "Checks".
  struct ReferenceCheckParameters
  {
    std::string   quantity;
    double        expected       = 0.;
    double        tolerance      = 1e-6;
    ToleranceType tolerance_type = ToleranceType::relative;

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;
  };

  /// Names and values of the final results, in order.
  using NamedValues = std::vector<std::pair<std::string, double>>;

  /**
   * Prints each check with what was found and whether it holds. Returns the
   * number of checks that do not. Throws UserError for an unknown quantity.
   */
  unsigned int
  evaluate_checks(
    const std::vector<std::pair<std::string, ReferenceCheckParameters>> &checks,
    const NamedValues &results,
    std::ostream      &out);
} // namespace stickslip

#endif
