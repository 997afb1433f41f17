// Plasticity with back stresses at a point, at small and at large strains:
// tangents, closed forms and an independent integration of a bar.

#include "mixed_hardening.h"

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/plane_stress.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace law_test;

namespace
{
  /// Worst error at random states, from the virgin state and after plastic
  /// steps (whose history is that of a general state).
  double
  worst_tangent_error(const std::shared_ptr<const ConstitutiveLaw> law,
                      const unsigned int                           dim)
  {
    double       worst     = 0.;
    unsigned int n_plastic = 0;
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        MaterialPoint point(law);
        for (unsigned int step = 0; step < 4; ++step)
          {
            const Tensor<2, 3> F = random_deformation_gradient(dim, 0.25);
            worst = std::max(worst, tangent_error(point, F, dim));
            point.evaluate(F);
            n_plastic += point.new_history[0] > point.old_history[0];
            point.accept();
          }
      }
    return n_plastic > 30 ? worst : 1e10;
  }



  /// Beside the yield surface, on its elastic and on its plastic side: worst
  /// error; 1e10 if it is not between the two.
  double
  error_at_yield(const std::shared_ptr<const ConstitutiveLaw> law)
  {
    MaterialPoint      point(law);
    const Tensor<2, 3> I = diagonal(1., 1., 1.);
    const Tensor<2, 3> F = random_deformation_gradient(3, 0.25);
    point.evaluate(F);
    point.accept(); // F is on the yield surface now
    double worst = 0.;
    for (const bool loads : {true, false})
      {
        const Tensor<2, 3> beside = F + (loads ? 1e-4 : -1e-4) * (F - I);
        point.evaluate(beside);
        if ((point.new_history[0] > point.old_history[0]) != loads)
          return 1e10;
        worst = std::max(worst, tangent_error(point, beside, 3));
      }
    return worst;
  }



  /// Equal and nearly equal stretches, in the virgin material and along the
  /// axes of an earlier flow.
  double
  error_at_equal_stretches(const std::shared_ptr<const ConstitutiveLaw> law)
  {
    double worst = 0.;
    for (const bool has_flowed : {false, true})
      for (const Tensor<2, 3> &F : {diagonal(1., 1., 1.),
                                    diagonal(1.2, 1.2, 1.2),
                                    diagonal(1.5, 0.8, 0.8),
                                    diagonal(1.5, 0.8, 0.8 + 1e-9)})
        {
          MaterialPoint point(law);
          if (has_flowed)
            {
              point.evaluate(diagonal(1.3, 0.9, 0.9));
              point.accept();
            }
          worst = std::max(worst, tangent_error(point, F, 3));
        }
    return worst;
  }



  /// In-plane deformations with a stretch across, as of bodies of revolution:
  /// the shears across stay exactly zero.
  bool
  stays_in_plane(const std::shared_ptr<const ConstitutiveLaw> law)
  {
    MaterialPoint point(law);
    double        worst = 0.;
    for (unsigned int step = 0; step < 5; ++step)
      {
        Tensor<2, 3> F = random_deformation_gradient(2, 0.25);
        F[2][2] += 0.2 * next_number();
        point.evaluate(F);
        point.accept();
        for (const unsigned int i : {0, 1})
          worst =
            std::max({worst, std::abs(point.P[i][2]), std::abs(point.P[2][i])});
        const auto names = law->history_names();
        for (unsigned int v = 0; v < names.size(); ++v)
          if (names[v].substr(names[v].size() - 2) == "xz" ||
              names[v].substr(names[v].size() - 2) == "yz")
            worst = std::max(worst, std::abs(point.new_history[v]));
      }
    return worst == 0. && point.new_history[0] > 0.;
  }



  void
  test_tangents()
  {
    for (const auto &[name, law] : all_laws())
      {
        print(name + ": tangent within 1e-6",
              worst_tangent_error(law, 3) < 1e-6);
        print(name + ", plane stress: tangent within 1e-6",
              worst_tangent_error(std::make_shared<PlaneStress>(law), 2) <
                1e-6);
        double worst = 0.;
        for (unsigned int sample = 0; sample < 10; ++sample)
          worst = std::max(worst, error_at_yield(law));
        print(name + ", beside the yield surface: tangent within 1e-6",
              worst < 1e-6);
        print(name + ", equal stretches: tangent within 1e-6",
              error_at_equal_stretches(law) < 1e-6);
        print(name + ": no shear across", stays_in_plane(law));
      }
  }



  /// A bar with free lateral strains in the law's own measures: strain and
  /// stress, or logarithmic strain and Kirchhoff stress.
  struct Bar
  {
    explicit Bar(const std::shared_ptr<const ConstitutiveLaw> law)
      : point(law)
      , is_small(law->is_geometrically_linear())
    {}

    /// The stress at the end of a step to @p strain; NaN without an answer.
    double
    stress_at(const double strain)
    {
      F[0][0] = is_small ? 1. + strain : std::exp(strain);
      if (point.relax(F, {1, 2}) > 0.)
        return std::nan("");
      return is_small ? point.P[0][0] : point.P[0][0] * F[0][0];
    }

    /// Steps to @p strain, each accepted; the last stress.
    double
    draw_to(const double from, const double strain, const unsigned int n_steps)
    {
      double stress = 0.;
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          stress = stress_at(from + (strain - from) * step / n_steps);
          point.accept();
        }
      return stress;
    }

    MaterialPoint point;
    const bool    is_small;
    Tensor<2, 3>  F = diagonal(1., 1., 1.);
  };



  /// Monotonic loading: the stress is R(p) + C_0 p + sum C/gamma (1 -
  /// exp(-gamma p)), in any number of steps.
  double
  monotonic_error(const std::shared_ptr<const ConstitutiveLaw> law,
                  const Hardening                             &kinematic)
  {
    double worst = 0.;
    for (const double sign : {1., -1.})
      for (const double p : {0.01, 0.1, 0.5})
        for (const unsigned int n_steps : {1, 7})
          {
            double stress = 0.1 + 0.02 * p + kinematic.modulus * p;
            for (const auto &[C, gamma] : kinematic.recovered)
              stress += C / gamma * (1. - std::exp(-gamma * p));
            Bar          bar(law);
            const double found = bar.draw_to(0., sign * (p + stress), n_steps);
            worst              = std::max({worst,
                                           std::abs(found - sign * stress),
                                           std::abs(bar.point.new_history[0] - p)});
          }
    return worst;
  }



  /// The rate equations of a bar, integrated by the classical Runge-Kutta
  /// method over the length of the plastic path.
  struct RateEquations
  {
    const Hardening    &kinematic;
    std::vector<double> X; ///< the linear back stress first
    double              plastic_strain = 0., p = 0.;

    explicit RateEquations(const Hardening &kinematic)
      : kinematic(kinematic)
      , X(1 + kinematic.recovered.size())
    {}

    std::vector<double>
    rate(const std::vector<double> &back_stresses, const double sign) const
    {
      std::vector<double> result = {sign * kinematic.modulus};
      for (unsigned int k = 1; k < X.size(); ++k)
        result.push_back(sign * kinematic.recovered[k - 1].first -
                         kinematic.recovered[k - 1].second * back_stresses[k]);
      return result;
    }

    double
    yield_at(const double sign) const
    {
      double stress = sign * (0.1 + 0.02 * p);
      for (const double part : X)
        stress += part;
      return stress;
    }

    void
    flow(const double dp, const double sign)
    {
      const auto moved = [this](const std::vector<double> &k, const double h) {
        std::vector<double> result = X;
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] += h * k[i];
        return result;
      };
      const auto k_1 = rate(X, sign);
      const auto k_2 = rate(moved(k_1, dp / 2.), sign);
      const auto k_3 = rate(moved(k_2, dp / 2.), sign);
      const auto k_4 = rate(moved(k_3, dp), sign);
      for (unsigned int i = 0; i < X.size(); ++i)
        X[i] += dp / 6. * (k_1[i] + 2. * k_2[i] + 2. * k_3[i] + k_4[i]);
      plastic_strain += sign * dp;
      p += dp;
    }

    /// The stress where the strain has gone on to @p strain.
    double
    draw_to(const double strain)
    {
      const double sign =
        strain - plastic_strain > yield_at(1.) ? 1. : -1.; // E = 1
      if (sign * (strain - plastic_strain - yield_at(sign)) <= 0.)
        return strain - plastic_strain;
      double dp = 2.5e-4;
      while (dp > 1e-15)
        {
          RateEquations trial = *this;
          trial.flow(dp, sign);
          if (sign * (strain - trial.plastic_strain - trial.yield_at(sign)) >
              0.)
            {
              X              = trial.X;
              plastic_strain = trial.plastic_strain;
              p              = trial.p;
            }
          else
            dp /= 2.;
        }
      return strain - plastic_strain;
    }
  };



  /// Cycles of growing size about a mean strain: worst difference of the
  /// stresses at their turning points.
  double
  cycle_error(const std::shared_ptr<const ConstitutiveLaw> law,
              const Hardening                             &kinematic,
              const unsigned int                           n_steps)
  {
    RateEquations reference(kinematic);
    Bar           bar(law);
    double        worst = 0., last = 0.;
    for (unsigned int turn = 1; turn <= 8; ++turn)
      {
        const double strain = 0.05 + (turn % 2 == 1 ? 0.08 : -0.08) * turn;
        worst               = std::max(worst,
                         std::abs(bar.draw_to(last, strain, n_steps) -
                                  reference.draw_to(strain)));
        last                = strain;
      }
    return worst;
  }



  /// Cycles between two stresses, without isotropic hardening: the plastic
  /// strain grows by 1/gamma ln((C^2 - gamma^2 X_min^2) / (C^2 - gamma^2
  /// X_max^2)) in each (Lemaitre and Chaboche, Mechanics of solid materials,
  /// 1990, section 5.4.4). Worst error of five cycles.
  template <typename Law>
  double
  ratchet_error()
  {
    const double C = 0.5, gamma = 5., yield = 0.1;
    const auto   law       = plastic_law<Law>({"", 0., {{C, gamma}}});
    law->hardening.type    = HardeningType::none;
    const double sigma_max = 0.17, sigma_min = -0.13;
    const double X_max = sigma_max - yield, X_min = sigma_min + yield;
    const double growth = std::log((C * C - gamma * gamma * X_min * X_min) /
                                   (C * C - gamma * gamma * X_max * X_max)) /
                          gamma;
    Bar    bar(law);
    double strain = 0., last = 0., worst = 0.;
    for (unsigned int cycle = 0; cycle < 6; ++cycle)
      {
        for (const double stress : {sigma_max, sigma_min})
          {
            // by halving, since the tangent jumps
            double low = strain - 1., high = strain + 1.;
            while (high - low > 1e-14)
              {
                const double middle             = 0.5 * (low + high);
                bar.F                           = diagonal(1., 1., 1.);
                const double reached            = bar.stress_at(middle);
                (reached < stress ? low : high) = middle;
              }
            strain = 0.5 * (low + high);
            bar.stress_at(strain);
            bar.point.accept();
          }
        if (cycle > 0) // the first one begins without a back stress
          worst = std::max(worst, std::abs(strain - last - growth));
        last = strain;
      }
    return growth > 0.01 ? worst : 1e10;
  }



  void
  test_uniaxial()
  {
    for (const Hardening &kinematic : hardenings)
      {
        const std::vector<NamedLaw> laws = {
          {"Hencky, ", plastic_law<HenckyPlasticity>(kinematic)},
          {"small strain, ", plastic_law<SmallStrainPlasticity>(kinematic)}};
        for (const auto &[name, law] : laws)
          {
            print(name + kinematic.name + ": monotonic, within 1e-11",
                  monotonic_error(law, kinematic) < 1e-11);
            print(name + kinematic.name + ": cycles, within 1e-10",
                  cycle_error(law, kinematic, 1) < 1e-10 &&
                    cycle_error(law, kinematic, 5) < 1e-10);
          }
      }
    print("Hencky: ratchetting, within 1e-11",
          ratchet_error<HenckyPlasticity>() < 1e-11);
    print("small strain: ratchetting, within 1e-11",
          ratchet_error<SmallStrainPlasticity>() < 1e-11);
  }
} // namespace



int
main()
{
  test_tangents();
  test_uniaxial();
}
