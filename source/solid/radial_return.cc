#include <stickslip/solid/radial_return.h>

#include <cmath>

namespace stickslip
{
  bool
  radial_return(const double              q,
                const double              shear_modulus,
                const double              kinematic_slope,
                const double              p_old,
                const IsotropicHardening &hardening,
                const ElasticConstants   &elastic,
                RadialReturn             &result)
  {
    // Roundoff of a state on the yield surface is no plastic flow.
    constexpr double       yield_tolerance = 1e-13;
    constexpr unsigned int max_iterations  = 100;

    result = RadialReturn();
    if (!std::isfinite(q))
      return false;
    auto yield = hardening.at(p_old, elastic, kinematic_slope);
    if (q <= yield.value * (1. + yield_tolerance))
      return true;

    // The residual q - stiffness dp - R(p_old + dp) falls from a positive
    // value at dp = 0 to a negative one at dp = q / stiffness.
    const double stiffness = 3. * shear_modulus + kinematic_slope;
    double       low = 0., high = q / stiffness, dp = 0.;
    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
      {
        const double residual = q - stiffness * dp - yield.value;
        const double step     = residual / (stiffness + yield.slope);
        if (std::abs(residual) <= 4e-16 * q || std::abs(step) <= 4e-16 * dp ||
            high - low <= 4e-16 * high)
          {
            result.is_plastic = true;
            result.dp         = dp;
            result.slope      = yield.slope;
            result.scale      = 1. - 3. * shear_modulus * dp / q;
            result.reduction  = 6. * shear_modulus * shear_modulus *
                               (1. / (stiffness + yield.slope) - dp / q);
            return true;
          }
        (residual > 0. ? low : high) = dp;
        dp += step;
        if (!(dp > low && dp < high))
          dp = 0.5 * (low + high);
        yield = hardening.at(p_old + dp, elastic, kinematic_slope);
      }
    return false;
  }
} // namespace stickslip
