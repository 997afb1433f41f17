#include <stickslip/solid/saint_venant_kirchhoff.h>

namespace stickslip
{
  void
  SaintVenantKirchhoff::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
  }



  void
  SaintVenantKirchhoff::check(const std::string &path) const
  {
    constants.check(path);
  }



  bool
  SaintVenantKirchhoff::evaluate(
    const Tensor<2, 3> &F,
    const ArrayView<const double> & /*old_history*/,
    const ArrayView<double> & /*new_history*/,
    Tensor<2, 3> &P,
    Tensor<4, 3> *dP_dF) const
  {
    // S(E) is finite there too, but the body would be turned inside out.
    if (!(determinant(F) > 0.))
      return false;

    const double lambda = constants.lame_lambda();
    const double mu     = constants.shear_modulus();

    const SymmetricTensor<2, 3> E = strain(F);
    const Tensor<2, 3>          S =
      lambda * trace(E) * unit_symmetric_tensor<3, double>() + 2. * mu * E;
    P = F * S;

    if (dP_dF != nullptr)
      {
        // A_iJkL = delta_ik S_JL + F_iM C_MJNL F_kN with the isotropic
        // C_MJNL = lambda d_MJ d_NL + mu (d_MN d_JL + d_ML d_JN)
        const Tensor<2, 3> B = F * transpose(F);
        Tensor<4, 3>      &A = *dP_dF;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int J = 0; J < 3; ++J)
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int L = 0; L < 3; ++L)
                A[i][J][k][L] =
                  (i == k ? S[J][L] : 0.) + lambda * F[i][J] * F[k][L] +
                  mu * ((J == L ? B[i][k] : 0.) + F[i][L] * F[k][J]);
      }
    return true;
  }



  double
  SaintVenantKirchhoff::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }
} // namespace stickslip
