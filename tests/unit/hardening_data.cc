// What hardening is made of: tables inline and from files, with the stresses
// and strains of either reading; back stresses; refused parameters.

#include "expect_error.h"
#include "law_at_a_point.h"

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

using namespace law_test;

namespace
{
  /// The same curve of a metal with E = 50 in all ways to give it: as the
  /// yield stress over the plastic strain, or as the whole curve over the total
  /// one.
  const NumberTable yield_curve = {{0., 1.}, {0.02, 2.}, {0.05, 2.5}};

  const double E = 50.;



  KinematicHardening
  mixed_hardening()
  {
    KinematicHardening kinematic;
    kinematic.modulus   = 3.;
    kinematic.recovered = {{40., 100.}, {20., 10.}};
    return kinematic;
  }



  IsotropicHardening
  tabulated(const NumberTable &table)
  {
    IsotropicHardening hardening;
    hardening.type  = HardeningType::tabulated;
    hardening.table = table;
    return hardening;
  }



  /// Worst difference of R at and between the points and beyond them.
  double
  difference(const IsotropicHardening &first,
             const IsotropicHardening &second,
             const KinematicHardening &kinematic = KinematicHardening())
  {
    ElasticConstants elastic;
    elastic.youngs_modulus = E;
    first.check("law", elastic, kinematic);
    second.check("law", elastic, kinematic);
    double worst = 0.;
    for (const double p : {0., 0.01, 0.02, 0.03, 0.05, 0.2})
      worst = std::max(worst,
                       std::abs(first.at(p, elastic, kinematic).value -
                                second.at(p, elastic, kinematic).value));
    return worst;
  }



  void
  test_readings()
  {
    const KinematicHardening kinematic = mixed_hardening();
    NumberTable              uniaxial  = yield_curve;
    for (auto &[strain, stress] : uniaxial)
      stress += kinematic.uniaxial_stress(strain);
    NumberTable measured = uniaxial;
    for (auto &[strain, stress] : measured)
      strain += stress / E;

    auto curve           = tabulated(uniaxial);
    curve.table_ordinate = TableOrdinate::uniaxial_stress;
    print("the uniaxial curve less the back stress is the yield stress",
          difference(curve, tabulated(yield_curve), kinematic) < 1e-12);
    curve.table          = measured;
    curve.table_abscissa = TableAbscissa::total_strain;
    print("also over the total strain",
          difference(curve, tabulated(yield_curve), kinematic) < 1e-12);
    const auto plain    = tabulated(yield_curve);
    auto       same     = plain;
    same.table_ordinate = TableOrdinate::uniaxial_stress;
    print("without back stresses both are the same",
          difference(plain, same) == 0.);
  }



  /// A bar of large strains runs through the points of the measured curve.
  void
  test_measured_curve()
  {
    HenckyPlasticity law;
    law.constants.youngs_modulus = E;
    law.kinematic                = mixed_hardening();
    law.hardening                = tabulated(yield_curve);
    law.hardening.table_ordinate = TableOrdinate::uniaxial_stress;
    law.hardening.table_abscissa = TableAbscissa::total_strain;
    law.hardening.table = {{0.02, 1.}, {0.1, 2.5}, {0.2, 4.}, {0.4, 5.5}};
    law.check("law");
    MaterialPoint point(std::make_shared<HenckyPlasticity>(law));
    double        worst = 0.;
    Tensor<2, 3>  F     = diagonal(1., 1., 1.);
    for (const auto &[strain, stress] : law.hardening.table)
      {
        F[0][0] = std::exp(strain);
        worst   = std::max({worst,
                            point.relax(F, {1, 2}),
                            std::abs(point.P[0][0] * F[0][0] - stress)});
        point.accept();
      }
    print("a bar runs through the points of its curve, within 1e-11",
          worst < 1e-11);
  }



  void
  test_files()
  {
    std::ofstream("curve.csv")
      << "# of a bar\nspecimen; plastic strain; stress\n"
      << "7; 0; 1\n7; 0.02; 2\n\n7; 0.05; 2.5 # the last\n";
    const auto read = [](const std::string              &name,
                         const std::vector<unsigned int> columns) {
      IsotropicHardening hardening;
      hardening.type          = HardeningType::tabulated;
      hardening.table_file    = name;
      hardening.table_columns = columns;
      hardening.read_table_file("Materials/steel", ".", MPI_COMM_WORLD);
      return hardening;
    };
    print("a table from a file is the same inline",
          difference(read("curve.csv", {2, 3}), tabulated(yield_curve)) == 0.);
    expect_error([&] { read("curve.csv", {2, 4}); });
    expect_error([&] { read("no_such_curve.csv", {1, 2}); });
    expect_error([&] {
      auto both       = tabulated(yield_curve);
      both.table_file = "curve.csv";
      both.read_table_file("Materials/steel", ".", MPI_COMM_WORLD);
    });
    expect_error([&] {
      ElasticConstants elastic;
      read("curve.csv", {3, 2}).check("Materials/steel", elastic);
    });
    std::ofstream("empty.csv") << "strain, stress\n";
    expect_error([&] {
      ElasticConstants elastic;
      read("empty.csv", {1, 2}).check("Materials/steel", elastic);
    });
  }



  /// The weights of the evolution against differences, and what two steps make
  /// of a back strain against one.
  void
  test_evolution()
  {
    double slopes = 0., halves = 0.;
    for (const double gamma : {0., 1., 500.})
      for (const double dp : {1e-6, 1.9e-6, 1e-3, 0.1})
        {
          const BackStress back_stress{1., gamma};
          const double     h = 1e-4 * dp;
          const auto       e = back_stress.evolution(dp),
                     more    = back_stress.evolution(dp + h),
                     less    = back_stress.evolution(dp - h),
                     half    = back_stress.evolution(dp / 2.);
          slopes             = std::max(
            {slopes,
                         std::abs((more.kept - less.kept) / (2. * h) - e.kept_slope) * dp,
                         std::abs((more.gained - less.gained) / (2. * h) - e.gained_slope) *
                           dp});
          halves = std::max(
            {halves,
             std::abs(half.kept * half.kept - e.kept),
             std::abs((half.kept + 1.) / 2. * half.gained - e.gained)});
        }
    print("slopes of the evolution within 1e-8", slopes < 1e-8);
    print("two halves of a step are the step, within 1e-14", halves < 1e-14);

    KinematicHardening slope = mixed_hardening(), constant = slope;
    constant.modulus_type = KinematicModulusType::prager_constant;
    print("the Prager constant is 3/2 of the slope",
          std::abs(1.5 * slope.uniaxial_stress(0.03) -
                   constant.uniaxial_stress(0.03)) < 1e-14);
  }



  void
  test_history()
  {
    HenckyPlasticity law;
    law.kinematic = mixed_hardening();
    for (const std::string &name : law.history_names())
      std::cout << name << ' ';
    std::cout << std::endl;
    SmallStrainPlasticity small;
    small.kinematic.modulus = 1.;
    print("Prager's back stress needs no history of its own",
          small.n_history_variables() == 7);
  }



  void
  test_parameters()
  {
    const auto refused =
      [](const std::vector<std::pair<std::string, std::string>> &values) {
        const auto law = create_constitutive_law("Hencky plasticity", "Law");
        ParameterHandler prm;
        law->add_parameters(prm);
        for (const auto &[name, value] : values)
          prm.set(name, value);
        expect_error([&] { law->check("Materials/steel"); });
      };
    refused({{"Kinematic modulus", "-1"}});
    refused({{"Back stresses", "1 : 0"}});
    refused({{"Back stresses", "5 : 10, -1 : 2"}});
    refused({{"Back stresses", "1:1, 1:1, 1:1, 1:1, 1:1, 1:1, 1:1, 1:1, 1:1"}});
    refused({{"Hardening", "tabulated"},
             {"Hardening table", "0 : 1, 0.1 : 1.5"},
             {"Hardening table ordinate", "uniaxial stress"},
             {"Kinematic modulus", "10"}});
    refused({{"Hardening", "linear"},
             {"Hardening modulus", "0.1"},
             {"Hardening modulus is", "tangent modulus"},
             {"Kinematic modulus", "0.1"},
             {"Kinematic modulus is", "Prager constant"}});
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_readings();
  test_measured_curve();
  test_files();
  test_evolution();
  test_history();
  test_parameters();
}
