#include <stickslip/solid/radial_return.h>

#include <cmath>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    // Roundoff of a state on the yield surface is no plastic flow.
    constexpr double yield_tolerance = 1e-13;



    struct ValueAndSlope
    {
      double value, slope;
    };



    /**
     * The root of a falling function, which is positive at 0 and negative at
     * @p high, by Newton's method within that interval. @p scale is the size
     * of the terms of which its values are sums. Returns false if there is
     * none within 100 iterations.
     */
    template <typename Function>
    bool
    find_root(const Function &function,
              const double    scale,
              double          high,
              double         &root)
    {
      double low = 0.;
      root       = 0.;
      for (unsigned int iteration = 0; iteration < 100; ++iteration)
        {
          const ValueAndSlope f    = function(root);
          const double        step = -f.value / f.slope;
          if (std::abs(f.value) <= 4e-16 * scale ||
              std::abs(step) <= 4e-16 * root || high - low <= 4e-16 * high)
            return true;
          (f.value > 0. ? low : high) = root;
          root += step;
          if (!(root > low && root < high))
            root = 0.5 * (low + high);
        }
      return false;
    }



    double
    von_mises_norm(const SymmetricTensor<2, 3> &deviator)
    {
      return std::sqrt(1.5) * deviator.norm();
    }



    /// xi of MixedReturn and the other sums over the back stresses, with their
    /// slopes over dp.
    struct TrialState
    {
      TrialState(const SymmetricTensor<2, 3>           &trial_stress,
                 const KinematicHardening              &kinematic,
                 const KinematicHardening::BackStrains &back_strains,
                 const double                           dp)
        : xi(trial_stress)
      {
        for (unsigned int k = 0; k < kinematic.n_terms(); ++k)
          {
            const BackStress term = kinematic.term(k);
            const auto       e    = term.evolution(dp);
            xi -= 2. / 3. * term.modulus * e.kept * back_strains[k];
            xi_slope -= 2. / 3. * term.modulus * e.kept_slope * back_strains[k];
            gained += term.modulus * e.gained * dp;
            gained_slope += term.modulus * e.kept;
          }
        q       = von_mises_norm(xi);
        q_slope = q > 0. ? 1.5 * (xi * xi_slope) / q : 0.;
      }

      SymmetricTensor<2, 3> xi, xi_slope;
      double                q, q_slope;
      double                gained = 0., gained_slope = 0.;
    };
  } // namespace



  bool
  radial_return(const double              q,
                const double              shear_modulus,
                const double              p_old,
                const IsotropicHardening &hardening,
                const ElasticConstants   &elastic,
                RadialReturn             &result)
  {
    result = RadialReturn();
    if (!std::isfinite(q))
      return false;
    if (q <= hardening.at(p_old, elastic).value * (1. + yield_tolerance))
      return true;

    const double stiffness = 3. * shear_modulus;
    const auto   excess    = [&](const double dp) -> ValueAndSlope {
      const auto yield = hardening.at(p_old + dp, elastic);
      result.slope     = yield.slope;
      return {q - stiffness * dp - yield.value, -(stiffness + yield.slope)};
    };
    if (!find_root(excess, q, q / stiffness, result.dp))
      return false;
    result.is_plastic = true;
    result.scale      = 1. - stiffness * result.dp / q;
    result.reduction  = 6. * shear_modulus * shear_modulus *
                       (1. / (stiffness + result.slope) - result.dp / q);
    return true;
  }



  bool
  mixed_return(const SymmetricTensor<2, 3>     &trial_stress,
               const double                     p_old,
               const IsotropicHardening        &hardening,
               const KinematicHardening        &kinematic,
               const ElasticConstants          &elastic,
               KinematicHardening::BackStrains &back_strains,
               MixedReturn                     &result)
  {
    result              = MixedReturn();
    const auto trial_at = [&](const double dp) {
      return TrialState(trial_stress, kinematic, back_strains, dp);
    };
    const double q = trial_at(0.).q;
    if (!std::isfinite(q))
      return false;
    if (q <=
        hardening.at(p_old, elastic, kinematic).value * (1. + yield_tolerance))
      return true;

    const double stiffness = 3. * elastic.shear_modulus();
    const auto   excess    = [&](const double dp) -> ValueAndSlope {
      const TrialState trial = trial_at(dp);
      const auto       yield = hardening.at(p_old + dp, elastic, kinematic);
      return {trial.q - stiffness * dp - trial.gained - yield.value,
              trial.q_slope - stiffness - trial.gained_slope - yield.slope};
    };
    // Whatever is recovered, xi is not larger than the sum of its parts.
    double largest_q = von_mises_norm(trial_stress);
    for (unsigned int k = 0; k < kinematic.n_terms(); ++k)
      largest_q +=
        2. / 3. * kinematic.term(k).modulus * von_mises_norm(back_strains[k]);
    double dp;
    if (!find_root(excess, largest_q, largest_q / stiffness, dp))
      return false;

    const TrialState end = trial_at(dp);
    result.is_plastic    = true;
    result.dp            = dp;
    result.N             = end.xi / end.xi.norm();
    result.flow          = std::sqrt(1.5) * dp * result.N;
    result.scale         = 1. - stiffness * dp / end.q;

    // d(dp) = sqrt(6) mu N:de / -slope, and recovery turns N by the part of
    // the slope of xi across N.
    const double mu        = elastic.shear_modulus();
    const double slope     = -excess(dp).slope;
    const double reduction = 6. * mu * mu * (1. / slope - dp / end.q);
    const SymmetricTensor<2, 3> across =
      end.xi_slope - (end.xi_slope * result.N) * result.N;
    result.V = reduction * result.N +
               (3. * std::sqrt(6.) * mu * mu * dp / (end.q * slope)) * across;

    for (unsigned int k = 0; k < kinematic.n_terms(); ++k)
      {
        const auto e    = kinematic.term(k).evolution(dp);
        back_strains[k] = e.kept * back_strains[k] + e.gained * result.flow;
      }
    return true;
  }
} // namespace stickslip
