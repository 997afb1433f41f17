// Plasticity at a point: tangents against central differences, closed forms of
// uniaxial tests, rotations, plane stress, parameters.

#include "law_at_a_point.h"

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/plane_stress.h>
#include <stickslip/solid/simo_miehe.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

using namespace law_test;

namespace
{
  const std::vector<std::string> hardening_types = {"none",
                                                    "linear",
                                                    "tabulated",
                                                    "power",
                                                    "Voce"};



  /// E = 1, nu = 0.3, yield stress 0.1 and hardening of the given type.
  template <typename Law>
  std::shared_ptr<Law>
  plastic_law(const std::string &type)
  {
    const auto law                  = std::make_shared<Law>();
    law->constants.youngs_modulus   = 1.;
    law->constants.poissons_ratio   = 0.3;
    law->hardening.type             = value_of(type, all_hardening_types());
    law->hardening.yield_stress     = 0.1;
    law->hardening.modulus          = 0.2;
    law->hardening.saturation       = 0.3;
    law->hardening.reference_strain = 0.1;
    law->hardening.exponent         = 0.3;
    law->hardening.table            = {{0., 0.1}, {0.1, 0.15}, {0.4, 0.17}};
    law->check("law");
    return law;
  }



  /// Tangents at random states, from the virgin state and after a first
  /// plastic step (whose history is then that of a general state).
  void
  test_tangents(const std::string                           &name,
                const std::shared_ptr<const ConstitutiveLaw> law,
                const unsigned int                           dim)
  {
    double       worst     = 0.;
    unsigned int n_plastic = 0;
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        MaterialPoint point(law);
        for (unsigned int step = 0; step < 3; ++step)
          {
            const Tensor<2, 3> F = random_deformation_gradient(dim, 0.25);
            worst = std::max(worst, tangent_error(point, F, dim));
            point.evaluate(F);
            n_plastic += (point.new_history[0] > point.old_history[0]);
            point.accept();
          }
      }
    print(name + ": tangent within 1e-6, mostly plastic",
          worst < 1e-6 && n_plastic > 20);
  }



  void
  test_all_tangents()
  {
    for (const std::string &type : hardening_types)
      {
        const auto simo          = plastic_law<SimoMiehe>(type);
        const auto hencky        = plastic_law<HenckyPlasticity>(type);
        const auto small         = plastic_law<SmallStrainPlasticity>(type);
        small->kinematic.modulus = 0.1;
        const auto rotating = std::make_shared<SmallStrainPlasticity>(*small);
        rotating->strain_measure = StrainMeasure::green_lagrange;
        const std::vector<
          std::pair<std::string, std::shared_ptr<ConstitutiveLaw>>>
          laws = {{"Simo-Miehe", simo},
                  {"Hencky", hencky},
                  {"small strain", small},
                  {"Green-Lagrange", rotating}};
        for (const auto &[name, law] : laws)
          {
            test_tangents(name + ", " + type, law, 3);
            test_tangents(name + ", " + type + ", plane stress",
                          std::make_shared<PlaneStress>(law),
                          2);
          }
      }

    // equal principal stretches, where divided differences have no meaning
    MaterialPoint hencky(plastic_law<HenckyPlasticity>("linear"));
    print("Hencky, three equal stretches: tangent within 1e-6",
          tangent_error(hencky, diagonal(1.2, 1.2, 1.2), 3) < 1e-6);
    print("Hencky, two equal stretches: tangent within 1e-6",
          tangent_error(hencky, diagonal(1.5, 0.8, 0.8), 3) < 1e-6);
    print("Hencky, nearly equal stretches: tangent within 1e-6",
          tangent_error(hencky, diagonal(1.5, 0.8, 0.8 + 1e-9), 3) < 1e-6);
  }



  /// Uniaxial loading to the stretch of the closed form in n steps: worst
  /// error of stress (over E) and equivalent plastic strain.
  double
  uniaxial_error(const std::shared_ptr<const ConstitutiveLaw> law,
                 const double                                 stretch,
                 const unsigned int                           n_steps,
                 const double                                 cauchy,
                 const double                                 p)
  {
    MaterialPoint point(law);
    Tensor<2, 3>  F = diagonal(1., 1., 1.);
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        F[0][0] = 1. + (stretch - 1.) * step / n_steps;
        if (point.relax(F, {1, 2}) > 0.)
          return 100.;
        point.accept();
      }
    const double found =
      law->cauchy_stress(law->full_deformation_gradient(
                           F,
                           ArrayView<const double>(point.new_history.data(),
                                                   point.new_history.size())),
                         point.P)[0][0];
    return std::max(std::abs(found - cauchy),
                    std::abs(point.new_history[0] - p));
  }



  /// E = 1, nu = 0.3, sy = 0.3; stretch and Cauchy stress where the plastic
  /// strain is p, for both laws.
  void
  test_finite_uniaxial()
  {
    struct Row
    {
      double H, p, simo_stretch, simo_cauchy, hencky_stretch, hencky_cauchy;
    };
    const std::vector<Row> table = {
      {0.6, 0.2, 1.734493689, 0.3633674836, 1.858928042, 0.3550486106},
      {0.6, 0.2, 0.5020885669, -0.5154247284, 0.5379444376, -0.4968333765},
      {0.6, 0.4, 0.3514175092, -0.7165056048, 0.3906278354, -0.6701952847},
      {1.5, 0.2, 1.946967073, 0.4931969619, 2.225540928, 0.4719767166},
      {1.5, 0.1, 0.5337387839, -0.5625, 0.5769498104, -0.5387478134}};
    double simo_error = 0., hencky_error = 0., plane_stress_error = 0.,
           modulus_error = 0.;
    for (const Row &row : table)
      {
        const auto simo              = plastic_law<SimoMiehe>("linear");
        const auto hencky            = plastic_law<HenckyPlasticity>("linear");
        simo->hardening.yield_stress = 0.3;
        hencky->hardening.yield_stress = 0.3;
        simo->hardening.modulus        = row.H;
        hencky->hardening.modulus      = row.H;
        simo_error                     = std::max(
          simo_error,
          uniaxial_error(simo, row.simo_stretch, 5, row.simo_cauchy, row.p));
        hencky_error =
          std::max(hencky_error,
                   uniaxial_error(
                     hencky, row.hencky_stretch, 5, row.hencky_cauchy, row.p));
        // P_33 = 0 from the adaptor, P_22 = 0 from the test
        MaterialPoint point(std::make_shared<PlaneStress>(hencky));
        Tensor<2, 3>  F = diagonal(row.hencky_stretch, 1., 1.);
        plane_stress_error =
          std::max({plane_stress_error,
                    point.relax(F, {1}),
                    std::abs(point.new_history[0] - row.p),
                    std::abs(point.new_history.back() - F[1][1])});
        if (row.H == 1.5)
          {
            hencky->hardening.modulus = 0.6;
            hencky->hardening.modulus_type =
              HardeningModulusType::tangent_modulus;
            modulus_error = std::max(modulus_error,
                                     uniaxial_error(hencky,
                                                    row.hencky_stretch,
                                                    5,
                                                    row.hencky_cauchy,
                                                    row.p));
          }
      }
    print("Hencky uniaxial within 1e-8", hencky_error < 1e-8);
    print("Hencky uniaxial in plane stress within 1e-8",
          plane_stress_error < 1e-8);
    print("Hencky, tangent modulus for slope within 1e-8",
          modulus_error < 1e-8);
    print("Simo-Miehe uniaxial within 1e-8", simo_error < 1e-8);
  }



  /// The strains at which the cycle (verification J1) turns.
  const std::array<double, 6> cycle_strains{
    {0.01, -0.01, 0.01, -0.01, 0.02, 0.}};



  /// Closed form of a bar with linear isotropic and kinematic hardening
  /// (slopes @p isotropic and @p kinematic over the axial plastic strain):
  /// stresses at the ends of the branches of the cycle, each of which turns
  /// from elastic to plastic once.
  std::array<double, 6>
  cycle_stresses(const double E,
                 const double yield_stress,
                 const double isotropic,
                 const double kinematic)
  {
    std::array<double, 6> stresses;
    double                plastic_strain = 0., accumulated = 0.;
    for (unsigned int branch = 0; branch < 6; ++branch)
      {
        const double driving = E * (cycle_strains[branch] - plastic_strain) -
                               kinematic * plastic_strain;
        const double excess =
          std::abs(driving) - yield_stress - isotropic * accumulated;
        if (excess > 0.)
          {
            const double increment = excess / (E + isotropic + kinematic);
            plastic_strain += std::copysign(increment, driving);
            accumulated += increment;
          }
        stresses[branch] = E * (cycle_strains[branch] - plastic_strain);
      }
    return stresses;
  }



  /// Steps of the axial strain with free lateral strains: the largest relative
  /// error of the stresses.
  double
  cycle_error(const SmallStrainPlasticity &law,
              const std::array<double, 6> &stresses)
  {
    law.check("law");
    MaterialPoint point(std::make_shared<SmallStrainPlasticity>(law));
    Tensor<2, 3>  F     = diagonal(1., 1., 1.);
    double        worst = 0.;
    for (unsigned int branch = 0; branch < 6; ++branch)
      {
        F[0][0] = 1. + cycle_strains[branch];
        worst   = std::max(worst, point.relax(F, {1, 2}));
        worst =
          std::max(worst, std::abs(point.P[0][0] / stresses[branch] - 1.));
        point.accept();
      }
    return worst;
  }



  void
  test_mixed_hardening()
  {
    const double          E = 179000.;
    SmallStrainPlasticity law;
    law.constants.youngs_modulus = E;
    law.constants.poissons_ratio = 0.3;
    law.hardening.yield_stress   = 335.;
    law.hardening.type           = HardeningType::linear;
    law.hardening.modulus        = 2726.;
    law.kinematic.modulus        = 1500.;
    print("cycle, slopes as given, within 1e-8",
          cycle_error(law, cycle_stresses(E, 335., 2726., 1500.)) < 1e-8);
    law.hardening.modulus_type = HardeningModulusType::tangent_modulus;
    law.kinematic.modulus_type = KinematicModulusType::prager_constant;
    const double kinematic     = 1.5 * 1500.;
    const double isotropic     = E * 2726. / (E - 2726.) - kinematic;
    print("cycle, tangent modulus and Prager constant, within 1e-8",
          cycle_error(law, cycle_stresses(E, 335., isotropic, kinematic)) <
            1e-8);
    // an independent table with 8 digits
    print("the closed form is that of the table, within 2e-8",
          std::abs(cycle_stresses(E, 335., isotropic, kinematic)[5] /
                     -380.33029 -
                   1.) < 2e-8);
  }



  /// A state turned by 90 degrees: P turns with it, the history stays.
  void
  test_rotation(const std::string                           &name,
                const std::shared_ptr<const ConstitutiveLaw> law)
  {
    Tensor<2, 3> R;
    R[0][1] = -1.;
    R[1][0] = R[2][2] = 1.;
    MaterialPoint      point(law);
    const Tensor<2, 3> first = random_deformation_gradient(3, 0.2);
    point.evaluate(first);
    const bool was_plastic = point.new_history[0] > 0.;
    point.accept();
    point.evaluate(first, false);
    const Tensor<2, 3>        P       = point.P;
    const std::vector<double> history = point.new_history;
    double                    worst   = 0.;
    // in steps of 9 degrees, each accepted
    for (unsigned int step = 1; step <= 10; ++step)
      {
        const double angle = step * std::acos(0.) / 10.;
        Tensor<2, 3> Q;
        Q[0][0] = Q[1][1] = std::cos(angle);
        Q[0][1]           = -std::sin(angle);
        Q[1][0]           = std::sin(angle);
        Q[2][2]           = 1.;
        point.evaluate(Q * first, false);
        worst = std::max(worst, (point.P - Q * P).norm());
        point.accept();
      }
    for (unsigned int i = 0; i < history.size(); ++i)
      worst = std::max(worst, std::abs(point.new_history[i] - history[i]));
    print(name + ": a rotation by 90 degrees changes nothing (1e-10)",
          was_plastic && worst < 1e-10);
  }



  template <typename Law>
  void
  test_plastic_flow_conserves_volume(const std::string &name)
  {
    MaterialPoint point(plastic_law<Law>("linear"));
    double        worst = 0.;
    for (unsigned int step = 0; step < 5; ++step)
      {
        point.evaluate(random_deformation_gradient(3, 0.3));
        point.accept();
        Tensor<2, 3> metric;
        for (unsigned int c = 0; c < 3; ++c)
          metric[c][c] = point.old_history[1 + c];
        metric[0][1] = metric[1][0] = point.old_history[4];
        metric[0][2] = metric[2][0] = point.old_history[5];
        metric[1][2] = metric[2][1] = point.old_history[6];
        worst = std::max(worst, std::abs(determinant(metric) - 1.));
      }
    print(name + ": plastic flow conserves the volume (1e-12)",
          point.old_history[0] > 0.1 && worst < 1e-12);
  }



  /// Large increments in one step, from metals to nearly rigid-plastic and
  /// rubber-like elastic strains: there always is an answer.
  void
  test_large_increments()
  {
    unsigned int n = 0, n_failed = 0;
    for (const std::string &type : hardening_types)
      for (const double yield_stress : {1e-4, 1e-3, 0.1, 1.})
        {
          const auto simo                = plastic_law<SimoMiehe>(type);
          const auto hencky              = plastic_law<HenckyPlasticity>(type);
          simo->hardening.yield_stress   = yield_stress;
          hencky->hardening.yield_stress = yield_stress;
          simo->hardening.saturation     = 3. * yield_stress;
          hencky->hardening.saturation   = 3. * yield_stress;
          for (unsigned int sample = 0; sample < 200; ++sample)
            {
              const Tensor<2, 3> F = random_deformation_gradient(3, 2.);
              if (determinant(F) < 0.05)
                continue;
              n += 2;
              MaterialPoint first(simo), second(hencky);
              n_failed += !first.evaluate(F) + !second.evaluate(F);
            }
        }
    print("large increments have an answer", n > 1000 && n_failed == 0);

    // small ones after large ones, for a metal
    n = n_failed                    = 0;
    const auto metal                = plastic_law<SimoMiehe>("linear");
    metal->constants.youngs_modulus = 1000.;
    metal->hardening.yield_stress   = 1.;
    metal->hardening.modulus        = 1.;
    for (const double size : {1e-3, 3e-3, 1e-2})
      for (unsigned int sample = 0; sample < 10000; ++sample)
        {
          MaterialPoint      point(metal);
          const Tensor<2, 3> F = random_deformation_gradient(3, 0.3);
          if (determinant(F) < 0.1 || !point.evaluate(F, false))
            continue;
          point.accept();
          ++n;
          n_failed +=
            !point.evaluate(random_deformation_gradient(3, size) * F, false);
        }
    print("small increments have an answer", n > 20000 && n_failed == 0);
  }



  /// A table over the total strain is the one over the plastic strain with
  /// stress/E added.
  void
  test_table()
  {
    ElasticConstants elastic;
    elastic.youngs_modulus = 50.;
    IsotropicHardening plastic;
    plastic.type             = HardeningType::tabulated;
    plastic.table            = {{0., 1.}, {0.02, 2.}, {0.05, 2.5}};
    IsotropicHardening total = plastic;
    total.table_abscissa     = TableAbscissa::total_strain;
    for (auto &[strain, stress] : total.table)
      strain += stress / elastic.youngs_modulus;
    total.check("law", elastic);
    double worst = 0.;
    for (const double p : {0., 0.01, 0.02, 0.03, 0.05, 0.2})
      worst = std::max(worst,
                       std::abs(total.at(p, elastic).value -
                                plastic.at(p, elastic).value));
    print("tables over plastic and over total strain agree",
          worst < 1e-12 &&
            std::abs(plastic.at(0.2, elastic).value - 5.) < 1e-12);
  }



  /// A line of a parameter file.
  struct Entry
  {
    std::string name, value;
  };



  void
  test_parameters()
  {
    const auto refused = [](const std::string        &law_name,
                            const std::vector<Entry> &values) {
      const auto       law = create_constitutive_law(law_name, "Law");
      ParameterHandler prm;
      law->add_parameters(prm);
      for (const auto &[name, value] : values)
        prm.set(name, value);
      try
        {
          law->check("Materials/steel");
          std::cout << law_name << ": accepted" << std::endl;
        }
      catch (const UserError &error)
        {
          std::cout << error.what() << std::endl;
        }
    };
    const std::string small = "small-strain plasticity";
    refused(small, {{"Yield stress", "0"}});
    refused(small, {{"Hardening", "tabulated"}});
    refused(small,
            {{"Hardening", "tabulated"},
             {"Hardening table", "0 : 1, 0.1 : 2, 0.2 : 1.5"}});
    refused(small,
            {{"Hardening", "tabulated"}, {"Hardening table", "0.1 : 1"}});
    refused(small,
            {{"Hardening", "tabulated"},
             {"Hardening table", "0 : 1, 0.1 : 2, 0.2 : 2.5"}});
    refused(small,
            {{"Hardening", "linear"},
             {"Hardening modulus", "2"},
             {"Hardening modulus is", "tangent modulus"}});
    refused(small,
            {{"Hardening", "linear"},
             {"Hardening modulus", "0.1"},
             {"Hardening modulus is", "tangent modulus"},
             {"Kinematic modulus", "0.5"}});
    refused("Hencky plasticity",
            {{"Hardening", "Voce"}, {"Saturation stress", "0.5"}});
    refused("Simo-Miehe plasticity",
            {{"Hardening", "power"}, {"Hardening exponent", "2"}});
    refused("hyperelastic", {{"C10", "-1"}});
    refused("hyperelastic", {{"Poisson's ratio", "0.5"}});
    refused("hyperelastic",
            {{"Poisson's ratio", "0.5"}, {"Bulk modulus", "100"}});
  }
} // namespace



int
main()
{
  test_all_tangents();
  test_finite_uniaxial();
  test_mixed_hardening();
  test_rotation("Simo-Miehe", plastic_law<SimoMiehe>("linear"));
  test_rotation("Hencky", plastic_law<HenckyPlasticity>("Voce"));
  const auto rotating         = plastic_law<SmallStrainPlasticity>("power");
  rotating->strain_measure    = StrainMeasure::green_lagrange;
  rotating->kinematic.modulus = 0.1;
  test_rotation("Green-Lagrange", rotating);
  test_plastic_flow_conserves_volume<SimoMiehe>("Simo-Miehe");
  test_plastic_flow_conserves_volume<HenckyPlasticity>("Hencky");
  test_large_increments();
  test_table();
  test_parameters();
}
