#ifndef stickslip_strategy_forcing_term_h
#define stickslip_strategy_forcing_term_h

#include <stickslip/strategy/convergence_criterion.h>

namespace stickslip
{
  /**
   * Relative linear residual that the iteration from @p state needs, @p before
   * being the iterate that preceded it: choice 2 of Eisenstat and Walker,
   * "Choosing the forcing terms in an inexact Newton method", SIAM J. Sci.
   * Comput. 17 (1996), with gamma = 0.9 and exponent 2, but not less than a
   * tenth of what the tolerances need, and at most 0.01 (Forcing::careful:
   * 1e-4). 0 without forcing.
   */
  double
  forcing_term(const Forcing               forcing,
               const ConvergenceCriterion &criterion,
               const NewtonIteration      &before,
               const NewtonIteration      &state);
} // namespace stickslip

#endif
