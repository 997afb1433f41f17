#ifndef stickslip_solid_principal_axes_h
#define stickslip_solid_principal_axes_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace stickslip
{
  /**
   * A symmetric tensor B = sum_a x_a n_a x n_a in its principal axes. It has to
   * be positive definite (a left or right Cauchy-Green tensor) where logarithms
   * are taken. Equal values need no care: everything is written with divided
   * differences that have a limit.
   */
  struct PrincipalAxes
  {
    explicit PrincipalAxes(const dealii::SymmetricTensor<2, 3> &B);

    /// False if a value is not positive or not a number.
    bool
    is_positive() const;

    /// e_a = 1/2 ln x_a
    std::array<double, 3>
    logarithmic_strains() const;

    /// (ln x_a - ln x_b) / (x_a - x_b), or 1/x_a for equal values
    double
    divided_log(const unsigned int a, const unsigned int b) const;

    /// sum_a values_a n_a x n_a
    dealii::SymmetricTensor<2, 3>
    tensor(const std::array<double, 3> &values) const;

    /**
     * The derivative of an isotropic function sum_a f(x_a) n_a x n_a,
     *
     *   H -> sum_ab f_ab (n_a . H n_b) n_a x n_b,
     *
     * with f_ab = (f(x_a) - f(x_b)) / (x_a - x_b), or f'(x_a) for equal values
     * (Daleckii and Krein; Bhatia, Matrix Analysis, theorem V.3.3).
     */
    dealii::SymmetricTensor<4, 3>
    derivative(const std::array<std::array<double, 3>, 3> &f) const;

    /// 1/2 ln B
    dealii::SymmetricTensor<2, 3>
    logarithmic_strain() const;

    dealii::SymmetricTensor<4, 3>
    logarithmic_strain_derivative() const;

    /// exp(factor B)
    dealii::SymmetricTensor<2, 3>
    exponential(const double factor) const;

    /// Its derivative over B.
    dealii::SymmetricTensor<4, 3>
    exponential_derivative(const double factor) const;

    std::array<double, 3>               values;
    std::array<dealii::Tensor<1, 3>, 3> axes;
  };

  /// (exp(a) - exp(b)) / (a - b), or exp(b) for equal values
  double
  divided_exponential(const double a, const double b);

  /**
   * The derivative of P = tau F^-T where the Kirchhoff stress tau is an
   * isotropic function of B = F Q F^T (Q fixed): tau = sum_a tau_a n_a x n_a,
   *
   *   A = sum_ab D_ab M_aa x M_bb
   *     + sum_(a != b) h_ab x_b M_ab x M_ab + (h_ab x_a - tau_a) M_ab x M_ba
   *     - sum_a tau_a M_aa x M_aa,         M_ab = n_a x (F^-1 n_b)
   *
   * with @p moduli D_ab = d tau_a / d e_b and @p shear_factors h_ab =
   * (tau_a - tau_b) / (x_a - x_b), symmetric.
   */
  dealii::Tensor<4, 3>
  nominal_tangent(const PrincipalAxes                        &principal,
                  const dealii::Tensor<2, 3>                 &inverse_F,
                  const std::array<double, 3>                &tau,
                  const std::array<std::array<double, 3>, 3> &moduli,
                  const std::array<std::array<double, 3>, 3> &shear_factors);
} // namespace stickslip

#endif
