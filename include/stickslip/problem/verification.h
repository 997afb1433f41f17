#ifndef stickslip_problem_verification_h
#define stickslip_problem_verification_h

#include <stickslip/contact/results/contact_check.h>

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  /// The section "Algorithm/Acceptance".
  struct VerificationParameters
  {
    double residual_tolerance = 1e-3;
    double law_tolerance      = 1e-3;

    void
    add_parameters(ParameterHandler &prm);
  };



  /// What the verification of a converged state found.
  struct Verification
  {
    ResidualNorms    residual; ///< with nothing frozen
    ContactViolation violation;
    std::string      errors; ///< empty: the state is accepted
  };

  /**
   * Verifies the state @p x independently of the algorithm that found it:
   * prescribed displacements, pairing, thresholds and statuses are taken
   * afresh, and the equilibrium residual and the contact law at every point are
   * evaluated with them. What @p problem returns later is the same as without
   * this call. Collective.
   */
  template <int dim>
  Verification
  verify_state(ContactProblem<dim>          &problem,
               const LA::BlockVector        &x,
               const VerificationParameters &parameters);
} // namespace stickslip

#endif
