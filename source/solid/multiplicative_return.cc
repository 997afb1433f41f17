#include <stickslip/solid/multiplicative_return.h>

#include <stickslip/solid/principal_axes.h>
#include <stickslip/solid/radial_return.h>
#include <stickslip/solid/symmetric_maps.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  using namespace dealii;
  using namespace SymmetricMaps;

  namespace
  {
    /// G B G for a symmetric G
    SymmetricTensor<2, 3>
    product(const Tensor<2, 3> &G, const SymmetricTensor<2, 3> &B)
    {
      return symmetrize(G * B * G);
    }



    /// The equations for the flow A: what they are made of, their residual
    /// dev T - X - 2/3 R/dp A, and its derivative.
    struct FlowEquations
    {
      FlowEquations(const SymmetricTensor<2, 3>           &C_trial,
                    const double                           p_old,
                    const IsotropicHardening              &hardening,
                    const KinematicHardening              &kinematic,
                    const ElasticConstants                &elastic,
                    const KinematicHardening::BackStrains &old_strains)
        : C_trial(C_trial)
        , p_old(p_old)
        , hardening(hardening)
        , kinematic(kinematic)
        , elastic(elastic)
        , old_strains(old_strains)
      {}

      /// Returns false if the numbers are not finite.
      bool
      evaluate(const SymmetricTensor<2, 3> &A)
      {
        if (!std::isfinite(A.norm()))
          return false;
        const PrincipalAxes axes(A);
        dp       = std::sqrt(2. / 3.) * A.norm();
        residual = 0.;
        slope    = 0.;
        if (!add_stress(axes))
          return false;
        for (unsigned int k = 0; k < kinematic.n_terms(); ++k)
          if (kinematic.term(k).modulus > 0. &&
              !subtract_back_stress(k, A, axes))
            return false;
        residual = deviator(residual);
        slope    = deviator_tensor<3>() * slope;

        const auto   yield = hardening.at(p_old + dp, elastic, kinematic);
        const double r     = 2. / 3. * yield.value / dp;
        residual -= r * A;
        slope -= r * identity_tensor<3>();
        add_outer_product(slope, (r - 2. / 3. * yield.slope) / dp, A, ddp(A));
        return std::isfinite(residual.norm());
      }

      double                          dp = 0.;
      SymmetricTensor<2, 3>           elastic_metric;
      Tensor<2, 3>                    inverse_G;
      SymmetricTensor<4, 3>           dinverse_G; ///< over A
      SymmetricTensor<4, 3>           dT_dmetric; ///< 2 mu de/dC^e
      KinematicHardening::BackStrains back_strains;
      SymmetricTensor<2, 3>           residual;
      SymmetricTensor<4, 3>           slope;

    private:
      /// d(dp)/dA
      SymmetricTensor<2, 3>
      ddp(const SymmetricTensor<2, 3> &A) const
      {
        return 2. / (3. * dp) * A;
      }

      bool
      add_stress(const PrincipalAxes &axes)
      {
        inverse_G      = axes.exponential(-1.);
        dinverse_G     = axes.exponential_derivative(-1.);
        elastic_metric = product(inverse_G, C_trial);
        const PrincipalAxes principal(elastic_metric);
        if (!principal.is_positive())
          return false;
        const double mu = elastic.shear_modulus();
        dT_dmetric      = 2. * mu * principal.logarithmic_strain_derivative();
        residual += 2. * mu * principal.logarithmic_strain();
        slope +=
          dT_dmetric * (symmetric_product(C_trial * inverse_G) * dinverse_G);
        return true;
      }

      bool
      subtract_back_stress(const unsigned int           k,
                           const SymmetricTensor<2, 3> &A,
                           const PrincipalAxes         &axes)
      {
        const BackStress            term = kinematic.term(k);
        const auto                  e    = term.evolution(dp);
        const Tensor<2, 3>          G    = axes.exponential(e.gained);
        const SymmetricTensor<2, 3> B =
          PrincipalAxes(old_strains[k]).exponential(2. * e.kept);
        const SymmetricTensor<2, 3> M = product(G, B);
        const PrincipalAxes         principal(M);
        if (!principal.is_positive())
          return false;
        back_strains[k] = principal.logarithmic_strain();

        const SymmetricTensor<2, 3> dM_ddp =
          2. * e.kept_slope *
            product(G, symmetrize(Tensor<2, 3>(old_strains[k]) * B)) +
          2. * e.gained_slope * symmetrize(Tensor<2, 3>(A) * M);
        SymmetricTensor<4, 3> dM =
          symmetric_product(B * G) * axes.exponential_derivative(e.gained);
        add_outer_product(dM, 1., dM_ddp, ddp(A));
        const double factor = 2. / 3. * term.modulus;
        residual -= factor * back_strains[k];
        slope -= factor * (principal.logarithmic_strain_derivative() * dM);
        return true;
      }

      const SymmetricTensor<2, 3>           &C_trial;
      const double                           p_old;
      const IsotropicHardening              &hardening;
      const KinematicHardening              &kinematic;
      const ElasticConstants                &elastic;
      const KinematicHardening::BackStrains &old_strains;
    };



    /// Newton's method from @p A, which becomes the solution; steps that lead
    /// away are halved.
    bool
    solve(FlowEquations         &equations,
          const double           yield_stress,
          const double           shear_modulus,
          SymmetricTensor<2, 3> &A)
    {
      SymmetricTensor<2, 3> step;
      const double          infinity   = std::numeric_limits<double>::max();
      double                last_merit = infinity;
      for (unsigned int iteration = 0; iteration < 50; ++iteration)
        {
          const double merit =
            equations.evaluate(A) ? equations.residual.norm() : infinity;
          if (merit == infinity && last_merit == infinity)
            return false;
          // down to roundoff, which the strains set
          const bool is_exact =
            merit <= 1e-13 * yield_stress + 1e-14 * shear_modulus;
          const bool has_stagnated =
            merit >= last_merit &&
            merit <= 1e-11 * yield_stress + 1e-13 * shear_modulus;
          if (is_exact || has_stagnated)
            return true;
          if (merit > 2. * last_merit)
            {
              step *= 0.5;
              A -= step;
              continue;
            }
          last_merit = merit;
          step       = -deviator(invert(equations.slope) * equations.residual);
          A += step;
        }
      return false;
    }
  } // namespace



  bool
  multiplicative_return(const SymmetricTensor<2, 3>     &C_trial,
                        const double                     p_old,
                        const IsotropicHardening        &hardening,
                        const KinematicHardening        &kinematic,
                        const ElasticConstants          &elastic,
                        KinematicHardening::BackStrains &back_strains,
                        MultiplicativeReturn            &result)
  {
    const PrincipalAxes principal(C_trial);
    if (!principal.is_positive())
      return false;
    result                = MultiplicativeReturn();
    result.elastic_metric = C_trial;
    result.inverse_G      = unit_symmetric_tensor<3, double>();

    const double                          mu          = elastic.shear_modulus();
    const KinematicHardening::BackStrains old_strains = back_strains;
    MixedReturn                           start;
    if (!mixed_return(2. * mu * deviator(principal.logarithmic_strain()),
                      p_old,
                      hardening,
                      kinematic,
                      elastic,
                      back_strains,
                      start))
      return false;
    if (!start.is_plastic)
      return true;

    FlowEquations equations(
      C_trial, p_old, hardening, kinematic, elastic, old_strains);
    SymmetricTensor<2, 3> A     = start.flow;
    const double          yield = hardening.at(p_old, elastic, kinematic).value;
    if (!solve(equations, yield, mu, A))
      return false;
    result.dp             = equations.dp;
    result.elastic_metric = equations.elastic_metric;
    result.inverse_G      = equations.inverse_G;
    back_strains          = equations.back_strains;

    // residual(A, C_trial) = 0 differentiated
    const SymmetricTensor<4, 3> dA =
      invert(equations.slope) *
      (deviator_tensor<3>() *
       (equations.dT_dmetric * congruence(equations.inverse_G)));
    result.dinverse_G = -1. * (equations.dinverse_G * dA);
    return true;
  }
} // namespace stickslip
