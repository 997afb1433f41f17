#ifndef stickslip_simulation_final_results_h
#define stickslip_simulation_final_results_h

#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/point_values.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/result_history.h>

#include <deal.II/base/tensor.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The results that a run prints at its end. They do not depend on the number
   * of ranks: six digits, and what is roundoff relative to its like is zero.
   */
  class FinalResults
  {
  public:
    /// Values whose names share the same @p family are compared for roundoff.
    void
    add(const std::string &family, const std::string &name, const double value);

    /// A resultant of the contact pair @p pair. Forces of all pairs are
    /// compared with each other, other vectors with their components.
    void
    add_of_pair(const std::string &pair, const NamedResultant &resultant);

    /// With the texts that print() prints.
    NamedValues
    values() const;

    void
    print(std::ostream &out) const;

  private:
    std::vector<std::pair<std::string, double>> named_values;
    std::vector<std::string>                    families;
  };



  /// The named points, the resultants of the contact pairs and the motions of
  /// reference points with free components in the present configuration.
  /// Collective.
  template <int dim>
  FinalResults
  final_results(const CaseParameters   &parameters,
                ContactProblem<dim>    &problem,
                const PointValues<dim> &point_values);
} // namespace stickslip

#endif
