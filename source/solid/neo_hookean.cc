#include <stickslip/solid/neo_hookean.h>

#include <stickslip/solid/tangent_terms.h>

#include <cmath>

namespace stickslip
{
  void
  NeoHookean::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
  }



  void
  NeoHookean::check(const std::string &path) const
  {
    constants.check(path);
  }



  bool
  NeoHookean::evaluate(const Tensor<2, 3> &F,
                       const ArrayView<const double> & /*old_history*/,
                       const ArrayView<double> & /*new_history*/,
                       Tensor<2, 3> &P,
                       Tensor<4, 3> *dP_dF) const
  {
    const double J = determinant(F);
    if (!(J > 0.))
      return false;

    const double       lambda = constants.lame_lambda();
    const double       mu     = constants.shear_modulus();
    const Tensor<2, 3> G      = transpose(invert(F));
    const double       g      = lambda * std::log(J) - mu;
    P                         = mu * F + g * G;

    if (dP_dF != nullptr)
      {
        Tensor<4, 3> &A = *dP_dF;
        A               = 0.;
        TangentTerms::add_product(A, lambda, G, G);
        TangentTerms::add_crossed_product(A, -g, G, G);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            A[i][j][i][j] += mu;
      }
    return true;
  }



  double
  NeoHookean::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }
} // namespace stickslip
