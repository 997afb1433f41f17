// Plasticity with back stresses at a point, at small and at large strains:
// tangents, closed forms, independent integrations, rotations, limits.

#include "law_at_a_point.h"

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/plane_stress.h>
#include <stickslip/solid/principal_axes.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <array>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace law_test;

namespace
{
  using BackStresses = std::vector<std::pair<double, double>>;

  /// The hardenings of the tests; moduli over a yield stress of 0.1.
  struct Hardening
  {
    std::string  name;
    double       modulus;
    BackStresses recovered;
  };

  const std::vector<Hardening> hardenings = {
    {"Prager", 0.1, {}},
    {"Armstrong-Frederick", 0., {{0.5, 5.}}},
    {"Chaboche", 0.05, {{2., 40.}, {0.5, 5.}, {0.1, 1.}}}};



  /// E = 1, nu = 0.3, yield stress 0.1, linear isotropic hardening.
  template <typename Law>
  std::shared_ptr<Law>
  plastic_law(const Hardening &kinematic)
  {
    const auto law                = std::make_shared<Law>();
    law->constants.youngs_modulus = 1.;
    law->constants.poissons_ratio = 0.3;
    law->hardening.type           = HardeningType::linear;
    law->hardening.yield_stress   = 0.1;
    law->hardening.modulus        = 0.02;
    law->kinematic.modulus        = kinematic.modulus;
    law->kinematic.recovered      = kinematic.recovered;
    law->check("law");
    return law;
  }



  struct NamedLaw
  {
    std::string                      name;
    std::shared_ptr<ConstitutiveLaw> law;
  };



  /// All laws with all back stresses.
  std::vector<NamedLaw>
  all_laws()
  {
    std::vector<NamedLaw> laws;
    for (const Hardening &kinematic : hardenings)
      {
        const auto rotating = plastic_law<SmallStrainPlasticity>(kinematic);
        rotating->strain_measure = StrainMeasure::green_lagrange;
        laws.push_back({"Hencky, " + kinematic.name,
                        plastic_law<HenckyPlasticity>(kinematic)});
        laws.push_back({"Green-Lagrange, " + kinematic.name, rotating});
        laws.push_back({"small strain, " + kinematic.name,
                        plastic_law<SmallStrainPlasticity>(kinematic)});
      }
    return laws;
  }



  // ------------------------------------------------------------------ tangents

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



  // -------------------------------------------------------------- uniaxial bar

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



  // ------------------------------------------------------------ large
  // rotations

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



  // ---------------------------------------------------------------------
  // limits

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
  test_tangents();
  test_uniaxial();
  test_rotations();
  test_limits();
}
