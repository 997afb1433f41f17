#ifndef stickslip_simulation_residual_trend_h
#define stickslip_simulation_residual_trend_h

#include <stickslip/strategy/newton_parameters.h>
#include <stickslip/strategy/newton_problem.h>

#include <vector>

namespace stickslip
{
  /// What the residuals of a Newton run that failed were doing at its end.
  enum class ResidualTrend
  {
    small,       ///< below its tolerances, but the unknowns keep changing
    unclear,     ///< to and fro, or too few iterations to say
    grows,       ///< and is far above its tolerance
    stagnates,   ///< just above its tolerance, as roundoff does
    falls_slowly ///< in every iteration
  };

  ResidualTrend
  residual_trend(const std::vector<NewtonIteration> &iterations,
                 const NewtonParameters             &newton);

  /// True if equilibrium, not contact, is the farther from its tolerance.
  bool
  equilibrium_is_worse(const NewtonIteration  &state,
                       const NewtonParameters &newton);
} // namespace stickslip

#endif
