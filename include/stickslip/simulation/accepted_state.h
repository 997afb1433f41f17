#ifndef stickslip_simulation_accepted_state_h
#define stickslip_simulation_accepted_state_h

#include <stickslip/base/types.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/work_balance.h>

namespace stickslip
{
  /**
   * What the next load step starts from, beside the histories of the problem.
   * Vectors of locally owned entries.
   */
  struct AcceptedState
  {
    LA::BlockVector x;              ///< displacements, multipliers
    LA::Vector      nodal_forces;   ///< internal plus contact forces at x
    LA::Vector      contact_forces; ///< at x
    /// Displacement per unit of load time over the last step, which predicts
    /// that of the next one; zero before the first.
    LA::Vector rate;

    /// The state zero of @p problem.
    template <int dim>
    static AcceptedState
    zero(const ContactProblem<dim> &problem);

    /// Goes on to @p x_new, which @p problem has accepted last. Adds the work of
    /// loads, supports and contact on the way, by the trapezoidal rule, and
    /// returns the displacements.
    template <int dim>
    LA::Vector
    advance(const LA::BlockVector &x_new,
            ContactProblem<dim>   &problem,
            WorkBalance           &work);
  };
} // namespace stickslip

#endif
