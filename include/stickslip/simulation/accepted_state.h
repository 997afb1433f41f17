#ifndef stickslip_simulation_accepted_state_h
#define stickslip_simulation_accepted_state_h

#include <stickslip/base/types.h>

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
  };
} // namespace stickslip

#endif
