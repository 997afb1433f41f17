#ifndef stickslip_simulation_dual_increment_h
#define stickslip_simulation_dual_increment_h

#include <stickslip/problem/contact_problem.h>

namespace stickslip
{
  /**
   * The increment of GCP: bodies linearized at @p state, contact as it is, with
   * inequalities, solved by a projected conjugate gradient in the multipliers.
   * Pairing and friction thresholds have to be frozen, which makes it a convex
   * problem (Tresca friction); thresholds of Coulomb friction are an outer
   * fixed point. Counts and times go to problem.counts. Throws NoConvergence.
   * Collective.
   */
  template <int dim>
  void
  solve_dual_increment(ContactProblem<dim>   &problem,
                       const LA::BlockVector &state,
                       LA::BlockVector       &increment);
} // namespace stickslip

#endif
