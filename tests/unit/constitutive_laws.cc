// Constitutive laws at a point: tangents against central differences, St
// Venant-Kirchhoff in uniaxial tension and compression, plane stress against
// its closed form.

#include <stickslip/base/user_error.h>

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/linear_elastic.h>
#include <stickslip/solid/material_parameters.h>
#include <stickslip/solid/plane_stress.h>
#include <stickslip/solid/saint_venant_kirchhoff.h>

#include <array>
#include <cmath>
#include <iostream>

using namespace stickslip;

namespace
{
  /// Numbers in [-1, 1], the same everywhere.
  double
  next_number()
  {
    static unsigned long state = 12345;
    state                      = (1103515245 * state + 12345) % 2147483648UL;
    return 2. * double(state) / 2147483648. - 1.;
  }



  Tensor<2, 3>
  random_deformation_gradient(const unsigned int dim)
  {
    Tensor<2, 3> F;
    for (unsigned int i = 0; i < 3; ++i)
      F[i][i] = 1.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        F[i][j] += 0.3 * next_number();
    return F;
  }



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



  /// Worst difference between tangent and central differences, relative to
  /// the modulus.
  double
  tangent_error(const ConstitutiveLaw &law, const unsigned int dim)
  {
    const double h     = 1e-5;
    double       worst = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
      {
        const Tensor<2, 3>    F      = random_deformation_gradient(dim);
        const PointEvaluation centre = evaluate(law, F);
        if (!centre.success)
          return 1e10;
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int l = 0; l < dim; ++l)
            {
              Tensor<2, 3> F_plus = F, F_minus = F;
              F_plus[k][l] += h;
              F_minus[k][l] -= h;
              const Tensor<2, 3> difference =
                (evaluate(law, F_plus).P - evaluate(law, F_minus).P) / (2 * h);
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  worst =
                    std::max(worst,
                             std::abs(centre.A[i][j][k][l] - difference[i][j]));
            }
      }
    return worst / law.longitudinal_modulus();
  }



  void
  print(const std::string &what, const bool holds)
  {
    std::cout << what << ": " << (holds ? "yes" : "NO") << std::endl;
  }



  void
  test_tangents()
  {
    for (const std::string &name : constitutive_law_names())
      {
        const std::unique_ptr<ConstitutiveLaw> law =
          create_constitutive_law(name, "Law");
        print(name + ": tangent within 1e-6", tangent_error(*law, 3) < 1e-6);
        const PlaneStress plane_stress(std::shared_ptr<ConstitutiveLaw>(
          create_constitutive_law(name, "Law")));
        print(name + ", plane stress: tangent within 1e-6",
              tangent_error(plane_stress, 2) < 1e-6);
      }
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
        const Tensor<2, 3>    F      = random_deformation_gradient(2);
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
          material.check("Materials/steel", 3);
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
  test_uniaxial();
  print("linear elastic, plane stress: closed form within 1e-11",
        plane_stress_error<LinearElastic>(false) < 1e-11);
  print("St Venant-Kirchhoff, plane stress: closed form within 1e-11",
        plane_stress_error<SaintVenantKirchhoff>(true) < 1e-11);
  test_parameters();
}
