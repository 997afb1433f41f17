// Hencky plasticity with back stresses on paths whose axes turn: simple shear,
// an independent integration, rotations, and the limits of isotropic hardening
// and of small strains.

#include "mixed_hardening.h"

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/principal_axes.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace law_test;

namespace
{
  /// Simple shear by @p n_steps to @p gamma of a material that is nearly rigid:
  /// F^p is F but for a rotation, so that the back stress is 2/3 C times the
  /// logarithmic strain of F, and the flow is along the rate of shear. Worst
  /// difference of the Kirchhoff stresses across on the way, over the yield
  /// stress.
  double
  shear_error(const double gamma, const unsigned int n_steps)
  {
    const double C = 0.1, yield = 0.1;
    const auto   law              = plastic_law<HenckyPlasticity>({"", C, {}});
    law->hardening.type           = HardeningType::none;
    law->constants.youngs_modulus = 1e5;
    MaterialPoint point(law);
    double        worst = 0.;
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        Tensor<2, 3> F = diagonal(1., 1., 1.);
        F[0][1]        = gamma * step / n_steps;
        point.evaluate(F);
        point.accept();
        const Tensor<2, 3> tau     = point.P * transpose(F);
        const double       g       = F[0][1];
        const double       stretch = std::asinh(g / 2.);
        const double       root    = std::sqrt(4. + g * g);
        const double       shear =
          yield / std::sqrt(3.) + 2. / 3. * C * stretch * 2. / root;
        const double difference = 4. / 3. * C * stretch * g / root;
        worst =
          std::max({worst,
                    std::abs(tau[0][1] - shear) / yield,
                    std::abs(tau[0][0] - tau[1][1] - difference) / yield});
      }
    return worst;
  }



  Tensor<2, 3>
  rotation(const double angle, const unsigned int axis)
  {
    const unsigned int i = (axis + 1) % 3, j = (axis + 2) % 3;
    Tensor<2, 3>       Q;
    Q[axis][axis] = 1.;
    Q[i][i] = Q[j][j] = std::cos(angle);
    Q[j][i]           = std::sin(angle);
    Q[i][j]           = -std::sin(angle);
    return Q;
  }



  /// Cycles of shear, in a body at rest and in one that turns meanwhile: the
  /// stress turns with it, the history is the same.
  double
  rotation_error(const std::shared_ptr<const ConstitutiveLaw> law)
  {
    MaterialPoint at_rest(law), turning(law);
    double        worst = 0.;
    for (unsigned int step = 1; step <= 20; ++step)
      {
        Tensor<2, 3> F = diagonal(1.05, 1., 0.97);
        F[0][1]        = 0.3 * std::sin(0.7 * step);
        F[1][2]        = 0.2 * std::sin(0.5 * step);
        const Tensor<2, 3> Q =
          rotation(0.4 * step, 2) * rotation(0.25 * step, 0);
        at_rest.evaluate(F, false);
        turning.evaluate(Q * F, false);
        at_rest.accept();
        turning.accept();
        worst = std::max(worst, (turning.P - Q * at_rest.P).norm());
        for (unsigned int v = 0; v < at_rest.old_history.size(); ++v)
          worst =
            std::max(worst,
                     std::abs(turning.old_history[v] - at_rest.old_history[v]));
      }
    return at_rest.old_history[0] > 0.3 ? worst : 1e10;
  }



  /// The rate equations in terms of F^p and F^pi themselves, integrated
  /// explicitly: the directions of the flow and of the recovery are those at
  /// the beginning of a step.
  struct MultiplicativeRates
  {
    explicit MultiplicativeRates(const HenckyPlasticity &law)
      : law(law)
      , Fp(diagonal(1., 1., 1.))
      , Fpi(law.kinematic.n_terms(), Fp)
    {}

    static SymmetricTensor<2, 3>
    half_log(const Tensor<2, 3> &C)
    {
      return PrincipalAxes(symmetrize(C)).logarithmic_strain();
    }

    SymmetricTensor<2, 3>
    deviatoric_stress(const Tensor<2, 3> &F) const
    {
      const Tensor<2, 3> Fe = F * invert(Fp);
      return 2. * law.constants.shear_modulus() *
             deviator(half_log(transpose(Fe) * Fe));
    }

    SymmetricTensor<2, 3>
    relative_stress(const Tensor<2, 3> &F) const
    {
      SymmetricTensor<2, 3> xi = deviatoric_stress(F);
      for (unsigned int k = 0; k < Fpi.size(); ++k)
        {
          const Tensor<2, 3> Fpe = Fp * invert(Fpi[k]);
          xi -= 2. / 3. * law.kinematic.term(k).modulus *
                deviator(half_log(Fpe * transpose(Fpe)));
        }
      return xi;
    }

    double
    excess(const Tensor<2, 3> &F) const
    {
      return std::sqrt(1.5) * relative_stress(F).norm() -
             law.hardening.at(p, law.constants, law.kinematic).value;
    }

    void
    flow(const double dp, const SymmetricTensor<2, 3> &direction)
    {
      const Tensor<2, 3> I = diagonal(1., 1., 1.);
      for (unsigned int k = 0; k < Fpi.size(); ++k)
        {
          const Tensor<2, 3> Fpe = Fp * invert(Fpi[k]);
          const Tensor<2, 3> a   = half_log(transpose(Fpe) * Fpe);
          Fpi[k] = (I + dp * law.kinematic.term(k).recovery * a) * Fpi[k];
        }
      Fp = (I + dp * Tensor<2, 3>(direction)) * Fp;
      Fp /= std::cbrt(determinant(Fp));
      p += dp;
    }

    /// The Cauchy stress deviator times the volume ratio at the end of a step.
    Tensor<2, 3>
    draw_to(const Tensor<2, 3> &F)
    {
      if (excess(F) > 0.)
        {
          const SymmetricTensor<2, 3> xi = relative_stress(F);
          const SymmetricTensor<2, 3> direction =
            std::sqrt(1.5) * xi / xi.norm();
          double dp = 0., last_dp = 0., last = excess(F);
          for (unsigned int i = 0; i < 30 && std::abs(last) > 1e-14; ++i)
            {
              const double next =
                i == 0 ? last / (3. * law.constants.shear_modulus()) : dp;
              MultiplicativeRates trial = *this;
              trial.flow(next, direction);
              const double value = trial.excess(F);
              dp      = next - value * (next - last_dp) / (value - last);
              last_dp = next;
              last    = value;
            }
          flow(last_dp, direction);
        }
      const Tensor<2, 3> Fe = F * invert(Fp);
      const Tensor<2, 3> T  = deviatoric_stress(F);
      return transpose(invert(Fe)) * T * transpose(Fe);
    }

    const HenckyPlasticity   &law;
    Tensor<2, 3>              Fp;
    std::vector<Tensor<2, 3>> Fpi;
    double                    p = 0.;
  };



  /// A cycle of shear with a stretch, whose axes turn: largest difference of
  /// the deviators of the Kirchhoff stress, over the yield stress.
  double
  rates_error(const Hardening &kinematic, const unsigned int n_steps)
  {
    const auto          law = plastic_law<HenckyPlasticity>(kinematic);
    MaterialPoint       point(law);
    MultiplicativeRates rates(*law);
    double              worst = 0.;
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        const double t = 6. * step / n_steps;
        Tensor<2, 3> F = diagonal(1. + 0.1 * t, 1., 1. - 0.05 * t);
        F[0][1]        = 1.5 * std::sin(t);
        point.evaluate(F, false);
        point.accept();
        const Tensor<2, 3> tau = point.P * transpose(F);
        worst                  = std::max(
          worst,
          (Tensor<2, 3>(deviator(symmetrize(tau))) - rates.draw_to(F)).norm() /
            0.1);
      }
    return worst;
  }



  void
  test_rotations()
  {
    // The backward direction of the flow is that of a method of first order.
    const double coarse = shear_error(5., 250), fine = shear_error(5., 500);
    print("Hencky, Prager: simple shear to 5 in 500 steps, within 1e-2",
          fine < 1e-2);
    print("Hencky, Prager: simple shear, half the error with half the step",
          std::abs(fine / coarse - 0.5) < 0.01);
    for (const Hardening &kinematic : hardenings)
      {
        const double first  = rates_error(kinematic, 1000),
                     second = rates_error(kinematic, 2000);
        print("Hencky, " + kinematic.name +
                ": the explicit rate equations, within terms of the step",
              second < 0.02 && std::abs(second / first - 0.5) < 0.05);
      }
    for (const auto &[name, law] : all_laws())
      if (!law->is_geometrically_linear())
        print(name + ": a rotation meanwhile changes nothing (1e-12)",
              rotation_error(law) < 1e-12);
  }



  /// Without back stresses to speak of: stress, tangent and metric on random
  /// paths are those of isotropic hardening. Worst difference.
  double
  isotropic_error()
  {
    const auto mixed =
      plastic_law<HenckyPlasticity>({"", 1e-14, {{1e-14, 5.}}});
    const auto isotropic = plastic_law<HenckyPlasticity>({"", 0., {}});
    double     worst     = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
      {
        MaterialPoint first(mixed), second(isotropic);
        for (unsigned int step = 0; step < 5; ++step)
          {
            const Tensor<2, 3> F = random_deformation_gradient(3, 0.3);
            if (!first.evaluate(F) || !second.evaluate(F))
              return 1e10;
            first.accept();
            second.accept();
            worst = std::max({worst,
                              (first.P - second.P).norm(),
                              (first.A - second.A).norm()});
            for (unsigned int v = 0; v < 7; ++v)
              worst = std::max(worst,
                               std::abs(first.old_history[v] -
                                        second.old_history[v]));
          }
      }
    return worst;
  }



  /// Strains and a yield stress of about @p size times those of the other
  /// tests, on a path without a fixed direction, with an own rotation of the
  /// same size: the largest difference to the law of small strains, over the
  /// yield stress.
  double
  small_strain_error(const Hardening &hardening, const double size)
  {
    Hardening scaled = hardening;
    for (auto &[C, gamma] : scaled.recovered)
      gamma /= size;
    const auto finite              = plastic_law<HenckyPlasticity>(scaled);
    const auto small               = plastic_law<SmallStrainPlasticity>(scaled);
    finite->hardening.yield_stress = 0.1 * size;
    small->hardening.yield_stress  = 0.1 * size;
    MaterialPoint first(finite), second(small);
    double        worst = 0.;
    for (unsigned int step = 0; step < 20; ++step)
      {
        const Tensor<2, 3> F = random_deformation_gradient(3, 0.5 * size);
        if (!first.evaluate(F) || !second.evaluate(F))
          return 1e10;
        first.accept();
        second.accept();
        worst = std::max(worst, (first.P - second.P).norm() / (0.1 * size));
      }
    return second.old_history[0] > size ? worst : 1e10;
  }



  /// The plastic volume is that of the beginning.
  double
  volume_error(const std::shared_ptr<const ConstitutiveLaw> law)
  {
    MaterialPoint point(law);
    double        worst = 0.;
    for (unsigned int step = 0; step < 50; ++step)
      {
        point.evaluate(random_deformation_gradient(3, 0.3));
        point.accept();
        Tensor<2, 3> Q;
        for (unsigned int c = 0; c < 3; ++c)
          Q[c][c] = point.old_history[1 + c];
        Q[0][1] = Q[1][0] = point.old_history[4];
        Q[0][2] = Q[2][0] = point.old_history[5];
        Q[1][2] = Q[2][1] = point.old_history[6];
        worst             = std::max(worst, std::abs(determinant(Q) - 1.));
      }
    return worst;
  }



  /// Steps from the virgin state to deformations of this size without an
  /// answer, of 1000.
  unsigned int
  n_without_answer(const std::shared_ptr<const ConstitutiveLaw> law,
                   const double                                 size)
  {
    unsigned int n = 0, n_failed = 0;
    while (n < 1000)
      {
        const Tensor<2, 3> F = random_deformation_gradient(3, size);
        if (determinant(F) < 0.05)
          continue;
        ++n;
        MaterialPoint point(law);
        n_failed += !point.evaluate(F, false);
      }
    return n_failed;
  }



  void
  test_limits()
  {
    print("Hencky: without back stresses that of isotropic hardening (1e-11)",
          isotropic_error() < 1e-11);
    for (const Hardening &kinematic : hardenings)
      {
        const auto law = plastic_law<HenckyPlasticity>(kinematic);
        print("Hencky, " + kinematic.name +
                ": that of small strains but for terms of the strain",
              small_strain_error(kinematic, 1e-6) < 20e-6 &&
                small_strain_error(kinematic, 1e-4) < 20e-4);
        print("Hencky, " + kinematic.name + ": plastic volume (1e-11)",
              volume_error(law) < 1e-11);
        print("Hencky, " + kinematic.name + ": large steps have an answer",
              n_without_answer(law, 0.5) == 0);
      }
  }
} // namespace



int
main()
{
  test_rotations();
  test_limits();
}
