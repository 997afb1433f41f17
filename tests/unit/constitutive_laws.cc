// Constitutive laws at a point: tangents against central differences, closed
// forms of homogeneous deformations, plane stress.

#include "law_at_a_point.h"

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/hyperelastic.h>
#include <stickslip/solid/linear_elastic.h>
#include <stickslip/solid/material_parameters.h>
#include <stickslip/solid/plane_stress.h>
#include <stickslip/solid/saint_venant_kirchhoff.h>

#include <array>
#include <string>
#include <vector>

using namespace law_test;

namespace
{
  struct PointEvaluation
  {
    bool         success;
    Tensor<2, 3> P;
    Tensor<4, 3> A;
  };



  PointEvaluation
  evaluate(const ConstitutiveLaw &law, const Tensor<2, 3> &F)
  {
    const unsigned int  n = law.n_history_variables();
    std::vector<double> old_history(n), new_history(n);
    law.initialize_history(ArrayView<double>(old_history.data(), n));
    PointEvaluation result;
    result.success =
      law.evaluate(F,
                   ArrayView<const double>(old_history.data(), n),
                   ArrayView<double>(new_history.data(), n),
                   result.P,
                   &result.A);
    return result;
  }



  double
  worst_tangent_error(const std::shared_ptr<const ConstitutiveLaw> law,
                      const unsigned int                           dim)
  {
    MaterialPoint point(law);
    double        worst = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
      worst = std::max(worst,
                       tangent_error(point,
                                     random_deformation_gradient(dim, 0.3),
                                     dim));
    return worst;
  }



  void
  test_tangents()
  {
    for (const std::string &name : constitutive_law_names())
      {
        const std::shared_ptr<ConstitutiveLaw> law =
          create_constitutive_law(name, "Law");
        print(name + ": tangent within 1e-6",
              worst_tangent_error(law, 3) < 1e-6);
        print(name + ", plane stress: tangent within 1e-6",
              worst_tangent_error(std::make_shared<PlaneStress>(law), 2) <
                1e-6);
      }
    const auto rubber = std::make_shared<Hyperelastic>();
    rubber->C10       = 0.8;
    rubber->C01       = 0.2;
    rubber->C20       = 0.1;
    print("hyperelastic with C01 and C20: tangent within 1e-6",
          worst_tangent_error(rubber, 3) < 1e-6);
  }



  /// Lateral stretches and nominal stresses of a block in uniaxial
  /// compression, plane strain and confinement at one axial stretch.
  struct HomogeneousRow
  {
    double C10, C01, C20, K, stretch;
    double uniaxial_lateral, uniaxial_stress;
    double plane_strain_lateral, plane_strain_stress;
    double confined_stress;
  };



  void
  test_hyperelastic()
  {
    const double                      K     = 13. / 3.;
    const std::vector<HomogeneousRow> table = {{1.,
                                                0.,
                                                0.,
                                                K,
                                                0.8,
                                                1.0667760432,
                                                -1.3254236764,
                                                1.0800073939,
                                                -1.4507455764,
                                                -1.5629049917},
                                               {1.,
                                                0.,
                                                0.,
                                                K,
                                                0.5,
                                                1.1610026458,
                                                -5.7131535679,
                                                1.0768288327,
                                                -5.4972697853,
                                                -5.3414687706},
                                               {1.,
                                                0.,
                                                0.,
                                                5.,
                                                0.5,
                                                1.2057067125,
                                                -5.9559771602,
                                                1.1191898520,
                                                -5.9056234093,
                                                -5.6748021039},
                                               {0.8,
                                                0.2,
                                                0.1,
                                                K,
                                                0.5,
                                                1.0537428627,
                                                -6.4208142411,
                                                1.0260660837,
                                                -6.1670479115,
                                                -6.0774218172},
                                               {0.8,
                                                0.2,
                                                0.1,
                                                K,
                                                1.2,
                                                0.9458459658,
                                                0.8553895937,
                                                0.9175780607,
                                                0.9376985825,
                                                1.2936995845}};
    double                            worst = 0.;
    for (const HomogeneousRow &row : table)
      {
        const auto law = std::make_shared<Hyperelastic>();
        law->C10       = row.C10;
        law->C01       = row.C01;
        law->C20       = row.C20;
        if (row.K != K) // otherwise from nu = 0.3
          law->given_bulk_modulus = row.K;
        MaterialPoint point(law);
        Tensor<2, 3>  F = diagonal(row.stretch, 1., 1.);
        point.evaluate(F);
        worst = std::max(worst, std::abs(point.P[0][0] - row.confined_stress));
        worst = std::max({worst,
                          point.relax(F, {1}),
                          std::abs(F[1][1] - row.plane_strain_lateral),
                          std::abs(point.P[0][0] - row.plane_strain_stress)});
        F     = diagonal(row.stretch, 1., 1.);
        worst = std::max({worst,
                          point.relax(F, {1, 2}),
                          std::abs(F[1][1] - row.uniaxial_lateral),
                          std::abs(point.P[0][0] - row.uniaxial_stress)});
      }
    print("hyperelastic homogeneous within 1e-8", worst < 1e-8);
  }



  /// Stretch, lateral stretch, nominal and Cauchy stress over E for nu = 0.3.
  void
  test_uniaxial()
  {
    const std::vector<std::array<double, 4>> table = {
      {{0.5, 1.106797181, -0.1875, -0.1530612245}},
      {{0.5773502692, 1.095445115, -0.1924500897, -0.1603750748}},
      {{0.6, 1.091787525, -0.192, -0.1610738255}},
      {{0.7, 1.073778376, -0.1785, -0.1548135299}},
      {{0.8, 1.052615789, -0.144, -0.1299638989}},
      {{0.9, 1.028105053, -0.0855, -0.08088930937}},
      {{1.1, 0.9679876032, 0.1155, 0.1232657417}},
      {{1.2, 0.9316651759, 0.264, 0.3041474654}},
      {{1.5, 0.790569415, 0.9375, 1.5}}};

    SaintVenantKirchhoff law;
    law.constants.youngs_modulus = 200.;
    law.constants.poissons_ratio = 0.3;
    double worst                 = 0.;
    for (const auto &row : table)
      {
        Tensor<2, 3> F;
        F[0][0] = row[0];
        F[1][1] = F[2][2]         = row[1];
        const Tensor<2, 3> P      = evaluate(law, F).P;
        const auto         cauchy = law.cauchy_stress(F, P);
        worst                     = std::max({worst,
                                              std::abs(P[0][0] / 200. - row[2]),
                                              std::abs(P[1][1] / 200.),
                                              std::abs(cauchy[0][0] / 200. - row[3])});
      }
    print("St Venant-Kirchhoff uniaxial within 1e-8", worst < 1e-8);

    Tensor<2, 3> F;
    F[0][0] = -1.;
    F[1][1] = F[2][2] = 1.;
    print("St Venant-Kirchhoff refuses negative volume",
          !evaluate(law, F).success);
  }



  /// S_33 = 0 leaves S = lambda' tr(E) I + 2 mu E in the plane, with
  /// lambda' = 2 lambda mu / (lambda + 2 mu); the same for small strains.
  template <typename Law>
  double
  plane_stress_error(const bool finite)
  {
    const auto law                = std::make_shared<Law>();
    law->constants.youngs_modulus = 100.;
    law->constants.poissons_ratio = 0.25;
    const double      lambda      = law->constants.lame_lambda();
    const double      mu          = law->constants.shear_modulus();
    const double      lambda_ps   = 2. * lambda * mu / (lambda + 2. * mu);
    const PlaneStress adaptor(law);

    double worst = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
      {
        const Tensor<2, 3>    F      = random_deformation_gradient(2, 0.3);
        SymmetricTensor<2, 3> strain = law->strain(F);
        strain[2][2]                 = 0.;
        Tensor<2, 3> stress          = 2. * mu * strain;
        stress[0][0] += lambda_ps * trace(strain);
        stress[1][1] += lambda_ps * trace(strain);
        const Tensor<2, 3>    expected = finite ? F * stress : stress;
        const PointEvaluation result   = evaluate(adaptor, F);
        worst =
          std::max(worst, result.success ? (result.P - expected).norm() : 1e10);
      }
    return worst / law->longitudinal_modulus();
  }



  void
  test_parameters()
  {
    const auto check = [](const std::string &name, const std::string &value) {
      MaterialParameters material;
      material.choose_law("St Venant-Kirchhoff", "Materials/steel");
      ParameterHandler prm;
      material.add_parameters(prm);
      prm.set(name, value);
      try
        {
          material.check("Materials/steel", 3, 1);
          std::cout << name << " = " << value << ": accepted" << std::endl;
        }
      catch (const UserError &error)
        {
          std::cout << error.what() << std::endl;
        }
    };
    check("Young's modulus", "0");
    check("Poisson's ratio", "0.5");
    check("Poisson's ratio", "-0.2");
    check("Plane stress", "true");
    try
      {
        MaterialParameters material;
        material.choose_law("rubber", "Materials/tyre");
      }
    catch (const UserError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }
} // namespace



int
main()
{
  test_tangents();
  test_hyperelastic();
  test_uniaxial();
  print("linear elastic, plane stress: closed form within 1e-11",
        plane_stress_error<LinearElastic>(false) < 1e-11);
  print("St Venant-Kirchhoff, plane stress: closed form within 1e-11",
        plane_stress_error<SaintVenantKirchhoff>(true) < 1e-11);
  test_parameters();
}
