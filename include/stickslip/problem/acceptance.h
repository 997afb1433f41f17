#ifndef stickslip_problem_acceptance_h
#define stickslip_problem_acceptance_h

#include <stickslip/contact/results/contact_check.h>

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  /// The section "Algorithm/Acceptance".
  struct AcceptanceParameters
  {
    double residual_tolerance = 1e-3;
    double law_tolerance      = 1e-3;

    void
    add_parameters(ParameterHandler &prm);
  };



  /// What an independent look at a converged state found.
  struct Acceptance
  {
    ResidualNorms    residual; ///< with nothing frozen
    ContactViolation violation;
    std::string      complaint; ///< empty: the state is accepted
  };

  /**
   * Looks at the state @p x as if no algorithm had frozen, held or adapted
   * anything: pairing, thresholds and statuses are taken afresh, and the
   * equilibrium residual and the contact law at every point are evaluated with
   * them. Leaves no trace in @p problem. Collective.
   */
  template <int dim>
  Acceptance
  examine(ContactProblem<dim>        &problem,
          const LA::BlockVector      &x,
          const AcceptanceParameters &parameters);
} // namespace stickslip

#endif
