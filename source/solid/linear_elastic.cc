#include <stickslip/solid/linear_elastic.h>

namespace stickslip
{
  void
  LinearElastic::add_parameters(ParameterHandler &prm)
  {
    constants.add_parameters(prm);
  }



  void
  LinearElastic::check(const std::string &path) const
  {
    constants.check(path);
  }



  bool
  LinearElastic::evaluate(const Tensor<2, 3> &F,
                          const ArrayView<const double> & /*old_history*/,
                          const ArrayView<double> & /*new_history*/,
                          Tensor<2, 3> &P,
                          Tensor<4, 3> *dP_dF) const
  {
    const double lambda = constants.lame_lambda();
    const double mu     = constants.shear_modulus();

    const SymmetricTensor<2, 3> eps = strain(F);
    P =
      lambda * trace(eps) * unit_symmetric_tensor<3, double>() + 2. * mu * eps;

    if (dP_dF != nullptr)
      {
        // lambda I x I + mu (I o I + its transpose in k, l)
        Tensor<4, 3> &A = *dP_dF;
        A               = 0.;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              A[i][i][j][j] += lambda;
              A[i][j][i][j] += mu;
              A[i][j][j][i] += mu;
            }
      }
    return true;
  }



  SymmetricTensor<2, 3>
  LinearElastic::cauchy_stress(const Tensor<2, 3> & /*F*/,
                               const Tensor<2, 3> &P) const
  {
    return symmetrize(P);
  }



  SymmetricTensor<2, 3>
  LinearElastic::strain(const Tensor<2, 3> &F) const
  {
    return symmetrize(F) - unit_symmetric_tensor<3, double>();
  }



  double
  LinearElastic::longitudinal_modulus() const
  {
    return constants.lame_lambda() + 2. * constants.shear_modulus();
  }
} // namespace stickslip
