#include <stickslip/solid/hyperelastic.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/tangent_terms.h>

#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    using namespace TangentTerms;

    /// An isochoric invariant with its first derivative, and what of the
    /// second one cannot be written down at once.
    struct Invariant
    {
      double       value;
      Tensor<2, 3> gradient;
    };

    /// I1 = J^(-2/3) F:F
    Invariant
    first_invariant(const Tensor<2, 3> &F,
                    const Tensor<2, 3> &G,
                    const double        j23)
    {
      Invariant I;
      I.value    = j23 * F.norm_square();
      I.gradient = 2. * j23 * F - 2. / 3. * I.value * G;
      return I;
    }



    /// A += factor d2 I1 / dF dF
    void
    add_second_derivative_of_I1(Tensor<4, 3>       &A,
                                const double        factor,
                                const Invariant    &I,
                                const Tensor<2, 3> &F,
                                const Tensor<2, 3> &G,
                                const double        j23)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          A[i][j][i][j] += 2. * factor * j23;
      add_product(A, -4. / 3. * factor * j23, F, G);
      add_product(A, -2. / 3. * factor, G, I.gradient);
      add_crossed_product(A, 2. / 3. * factor * I.value, G, G);
    }



    /// I2 = J^(-4/3) ((F:F)^2 - B:B) / 2, B = F F^T. @p unscaled is the
    /// gradient of J^(4/3) I2, 2 (F:F) F - 2 B F.
    Invariant
    second_invariant(const Tensor<2, 3> &F,
                     const Tensor<2, 3> &G,
                     const Tensor<2, 3> &B,
                     const double        j43,
                     Tensor<2, 3>       &unscaled)
    {
      const double trace_B = trace(B);
      unscaled             = 2. * trace_B * F - 2. * (B * F);
      Invariant I;
      I.value    = 0.5 * j43 * (trace_B * trace_B - B.norm_square());
      I.gradient = j43 * unscaled - 4. / 3. * I.value * G;
      return I;
    }



    /// A += factor d2 I2 / dF dF
    void
    add_second_derivative_of_I2(Tensor<4, 3>       &A,
                                const double        factor,
                                const Invariant    &I,
                                const Tensor<2, 3> &F,
                                const Tensor<2, 3> &G,
                                const Tensor<2, 3> &B,
                                const double        j43,
                                const Tensor<2, 3> &unscaled)
    {
      const double c = factor * j43;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          A[i][j][i][j] += 2. * c * trace(B);
      add_product(A, 4. * c, F, F);
      add_material(A, -2. * c * (transpose(F) * F));
      add_crossed_product(A, -2. * c, F, F);
      add_spatial(A, -2. * c * B);
      add_product(A, -4. / 3. * c, unscaled, G);
      add_product(A, -4. / 3. * factor, G, I.gradient);
      add_crossed_product(A, 4. / 3. * factor * I.value, G, G);
    }
  } // namespace



  void
  Hyperelastic::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("C10",
                      C10,
                      "Of W = C10 (I1 - 3) + C01 (I2 - 3) + C20 (I1 - 3)^2 + "
                      "K/2 (J - 1)^2, I1 and I2 isochoric; force per area.",
                      Patterns::Double());
    prm.add_parameter("C01", C01, "Force per area.", Patterns::Double());
    prm.add_parameter("C20", C20, "Force per area.", Patterns::Double());
    prm.add_parameter("Poisson's ratio",
                      poissons_ratio,
                      "nu at small strains, between -1 and 0.5, both excluded. "
                      "K = 4 (C10 + C01)(1 + nu)/(3 (1 - 2 nu)). Unused if "
                      "'Bulk modulus' is given.",
                      Patterns::Double());
    prm.add_parameter("Bulk modulus",
                      given_bulk_modulus,
                      "K, force per area; 0: from Poisson's ratio.",
                      Patterns::Double());
  }



  void
  Hyperelastic::check(const std::string &path) const
  {
    std::ostringstream text;
    if (!(C10 + C01 > 0.))
      {
        text << path << "/C10 + C01 is " << C10 + C01
             << ", but has to be greater than 0: it is half of the shear "
                "modulus.";
        throw UserError(text.str());
      }
    if (!(given_bulk_modulus >= 0.))
      {
        text << path << "/Bulk modulus is " << given_bulk_modulus
             << ", but has to be greater than 0, or 0 to take it from "
                "Poisson's ratio.";
        throw UserError(text.str());
      }
    if (given_bulk_modulus == 0. &&
        !(poissons_ratio > -1. && poissons_ratio < 0.5))
      {
        text << path << "/Poisson's ratio is " << poissons_ratio
             << ", but has to be greater than -1 and less than 0.5.";
        throw UserError(text.str());
      }
  }



  double
  Hyperelastic::bulk_modulus() const
  {
    if (given_bulk_modulus > 0.)
      return given_bulk_modulus;
    return 4. * (C10 + C01) * (1. + poissons_ratio) /
           (3. * (1. - 2. * poissons_ratio));
  }



  bool
  Hyperelastic::evaluate(const Tensor<2, 3> &F,
                         const ArrayView<const double> & /*old_history*/,
                         const ArrayView<double> & /*new_history*/,
                         Tensor<2, 3> &P,
                         Tensor<4, 3> *dP_dF) const
  {
    const double J = determinant(F);
    if (!(J > 0.))
      return false;

    const double       K   = bulk_modulus();
    const double       j23 = 1. / std::cbrt(J * J);
    const double       j43 = j23 * j23;
    const Tensor<2, 3> G   = transpose(invert(F));
    const Tensor<2, 3> B   = F * transpose(F);
    const Invariant    I1  = first_invariant(F, G, j23);

    const double W_1 = C10 + 2. * C20 * (I1.value - 3.);
    const double U   = K * (J - 1.) * J; // J dU/dJ
    P                = W_1 * I1.gradient + U * G;
    Invariant    I2;
    Tensor<2, 3> unscaled;
    if (C01 != 0.)
      {
        I2 = second_invariant(F, G, B, j43, unscaled);
        P += C01 * I2.gradient;
      }

    if (dP_dF != nullptr)
      {
        Tensor<4, 3> &A = *dP_dF;
        A               = 0.;
        add_second_derivative_of_I1(A, W_1, I1, F, G, j23);
        if (C20 != 0.)
          add_product(A, 2. * C20, I1.gradient, I1.gradient);
        if (C01 != 0.)
          add_second_derivative_of_I2(A, C01, I2, F, G, B, j43, unscaled);
        add_product(A, K * (2. * J - 1.) * J, G, G);
        add_crossed_product(A, -U, G, G);
      }
    return true;
  }



  double
  Hyperelastic::longitudinal_modulus() const
  {
    return bulk_modulus() + 8. / 3. * (C10 + C01);
  }
} // namespace stickslip
