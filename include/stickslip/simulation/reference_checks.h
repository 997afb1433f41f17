#ifndef stickslip_simulation_reference_checks_h
#define stickslip_simulation_reference_checks_h

#include <stickslip/base/choice.h>

#include <stickslip/simulation/result_history.h>

#include <deal.II/base/parameter_handler.h>

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

  /// Which of the values of a quantity over the steps is compared.
  enum class CheckedValue
  {
    at_the_end,
    at_a_time,
    minimum, ///< over all accepted steps
    maximum
  };

  /// A result of the run with its known value: a member of section "Checks".
  struct ReferenceCheckParameters
  {
    std::string   quantity; ///< a name, or an expression of names
    CheckedValue  checked_value  = CheckedValue::at_the_end;
    double        time           = 0.; ///< with `at_a_time`
    double        expected       = 0.;
    double        tolerance      = 1e-6;
    ToleranceType tolerance_type = ToleranceType::relative;

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// Largest difference from the known value.
    double
    largest_difference() const;
  };

  using ReferenceChecks =
    std::vector<std::pair<std::string, ReferenceCheckParameters>>;

  /// What came of the checks: a line for each, and those that fall short.
  struct CheckReport
  {
    unsigned int n_failed = 0;
    std::string  text, failed;
  };

  using ResultTables = std::vector<const StatisticsTable *>;

  /// Throws UserError for a quantity that no table has a column for.
  /// Collective.
  void
  check_quantities(const ReferenceChecks &checks,
                   const ResultTables    &tables,
                   const MPI_Comm         communicator);

  /// Compares. Throws UserError for an unknown quantity, and for a time at
  /// which no step ends. The texts are on rank 0 only. Collective.
  CheckReport
  evaluate_checks(const ReferenceChecks &checks,
                  const ResultTables    &tables,
                  const NamedValues     &at_end,
                  const MPI_Comm         communicator);
} // namespace stickslip

#endif
