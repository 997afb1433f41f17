#include <stickslip/strategy/forcing_term.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Reduction of the linear residual that every iteration needs, the first
    /// one, which applies prescribed displacements, included.
    constexpr double largest_forcing = 0.01;

    /// The same of Forcing::careful: statuses hardly ever change by it.
    constexpr double largest_careful_forcing = 1e-4;

    /// Factor of choice 2.
    constexpr double gamma = 0.9;

    /// What the tolerances need is reached with this factor to spare.
    constexpr double share_of_tolerance = 0.1;
  } // namespace



  double
  forcing_term(const Forcing               forcing,
               const ConvergenceCriterion &criterion,
               const NewtonIteration      &before,
               const NewtonIteration      &state)
  {
    if (forcing == Forcing::none)
      return 0.;
    const double largest =
      forcing == Forcing::careful ? largest_careful_forcing : largest_forcing;
    // residuals do not compare while displacements are not applied
    if (before.prescribed > 0. || state.prescribed > 0.)
      return largest;
    const double ratio = criterion.excess(state) / criterion.excess(before);
    return std::min(largest,
                    std::max(gamma * ratio * ratio,
                             share_of_tolerance / criterion.excess(state)));
  }
} // namespace stickslip
