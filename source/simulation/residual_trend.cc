#include <stickslip/simulation/residual_trend.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Iterations over which a trend is seen.
    constexpr unsigned int n_seen = 5;

    /// A residual that is this much above its tolerance and does not fall any
    /// more is probably roundoff.
    constexpr double near_tolerance = 1e3;

    /// One that grows counts as diverging beyond this.
    constexpr double far_from_tolerance = 1e6;



    double
    over(const double residual, const double tolerance)
    {
      return residual / std::max(tolerance, std::numeric_limits<double>::min());
    }
  } // namespace



  ResidualTrend
  residual_trend(const std::vector<NewtonIteration> &iterations,
                 const NewtonParameters             &newton)
  {
    if (!iterations.empty() && iterations.back().prescribed == 0. &&
        iterations.back().equilibrium <= newton.equilibrium_tolerance &&
        iterations.back().contact <= newton.contact_tolerance)
      return ResidualTrend::small;
    // the first residual is that of displacements not applied yet
    if (iterations.size() <= n_seen + 1)
      return ResidualTrend::unclear;
    std::vector<double> sizes;
    for (auto state = iterations.begin() + 1; state != iterations.end();
         ++state)
      sizes.push_back(
        std::max(over(state->equilibrium, newton.equilibrium_tolerance),
                 over(state->contact, newton.contact_tolerance)));
    const auto   last  = sizes.end() - n_seen;
    const double least = *std::min_element(last, sizes.end());
    const double most  = *std::max_element(last, sizes.end());
    if (sizes.back() > 10. * sizes.front() && sizes.back() > far_from_tolerance)
      return ResidualTrend::grows;
    if (most < near_tolerance && least > 0.2 * most)
      return ResidualTrend::stagnates;
    if (std::is_sorted(last, sizes.end(), std::greater<double>()))
      return ResidualTrend::falls_slowly;
    return ResidualTrend::unclear;
  }



  bool
  equilibrium_is_worse(const NewtonIteration  &state,
                       const NewtonParameters &newton)
  {
    return over(state.equilibrium, newton.equilibrium_tolerance) >
           over(state.contact, newton.contact_tolerance);
  }
} // namespace stickslip
