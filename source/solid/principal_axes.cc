#include <stickslip/solid/principal_axes.h>

#include <stickslip/solid/symmetric_maps.h>
#include <stickslip/solid/tangent_terms.h>

#include <cmath>

namespace stickslip
{
  using namespace dealii;



  PrincipalAxes::PrincipalAxes(const SymmetricTensor<2, 3> &B)
  {
    const auto pairs =
      eigenvectors(B, SymmetricTensorEigenvectorMethod::jacobi);
    for (unsigned int a = 0; a < 3; ++a)
      {
        values[a] = pairs[a].first;
        axes[a]   = pairs[a].second;
      }
  }



  bool
  PrincipalAxes::is_positive() const
  {
    for (const double value : values)
      if (!(value > 0. && std::isfinite(value)))
        return false;
    return true;
  }



  std::array<double, 3>
  PrincipalAxes::logarithmic_strains() const
  {
    return {{0.5 * std::log(values[0]),
             0.5 * std::log(values[1]),
             0.5 * std::log(values[2])}};
  }



  double
  PrincipalAxes::divided_log(const unsigned int a, const unsigned int b) const
  {
    // ln(x_a / x_b) = log1p(d) keeps all digits for x_a close to x_b.
    const double d = (values[a] - values[b]) / values[b];
    return (d == 0. ? 1. : std::log1p(d) / d) / values[b];
  }



  SymmetricTensor<2, 3>
  PrincipalAxes::tensor(const std::array<double, 3> &principal_values) const
  {
    SymmetricTensor<2, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        for (unsigned int a = 0; a < 3; ++a)
          result[i][j] += principal_values[a] * axes[a][i] * axes[a][j];
    return result;
  }



  SymmetricTensor<4, 3>
  PrincipalAxes::derivative(const std::array<std::array<double, 3>, 3> &f) const
  {
    SymmetricTensor<4, 3> result;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = a; b < 3; ++b)
        {
          const SymmetricTensor<2, 3> n =
            symmetrize(outer_product(axes[a], axes[b]));
          SymmetricMaps::add_outer_product(result,
                                           (a == b ? 1. : 2.) * f[a][b],
                                           n,
                                           n);
        }
    return result;
  }



  SymmetricTensor<2, 3>
  PrincipalAxes::logarithmic_strain() const
  {
    return tensor(logarithmic_strains());
  }



  SymmetricTensor<4, 3>
  PrincipalAxes::logarithmic_strain_derivative() const
  {
    std::array<std::array<double, 3>, 3> f;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        f[a][b] = 0.5 * divided_log(a, b);
    return derivative(f);
  }



  SymmetricTensor<2, 3>
  PrincipalAxes::exponential(const double factor) const
  {
    return tensor({{std::exp(factor * values[0]),
                    std::exp(factor * values[1]),
                    std::exp(factor * values[2])}});
  }



  SymmetricTensor<4, 3>
  PrincipalAxes::exponential_derivative(const double factor) const
  {
    std::array<std::array<double, 3>, 3> f;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        f[a][b] =
          factor * divided_exponential(factor * values[a], factor * values[b]);
    return derivative(f);
  }



  double
  divided_exponential(const double a, const double b)
  {
    const double d = a - b;
    return std::exp(b) * (d == 0. ? 1. : std::expm1(d) / d);
  }



  Tensor<4, 3>
  nominal_tangent(const PrincipalAxes                        &principal,
                  const Tensor<2, 3>                         &inverse_F,
                  const std::array<double, 3>                &tau,
                  const std::array<std::array<double, 3>, 3> &moduli,
                  const std::array<std::array<double, 3>, 3> &shear_factors)
  {
    std::array<std::array<Tensor<2, 3>, 3>, 3> M;
    for (unsigned int b = 0; b < 3; ++b)
      {
        const Tensor<1, 3> axis = inverse_F * principal.axes[b];
        for (unsigned int a = 0; a < 3; ++a)
          M[a][b] = outer_product(principal.axes[a], axis);
      }

    Tensor<4, 3> A;
    for (unsigned int a = 0; a < 3; ++a)
      {
        // sum_b D_ab M_bb first: one product of tensors instead of three
        Tensor<2, 3> row;
        for (unsigned int b = 0; b < 3; ++b)
          row += (moduli[a][b] - (a == b ? tau[a] : 0.)) * M[b][b];
        TangentTerms::add_product(A, 1., M[a][a], row);

        for (unsigned int b = 0; b < 3; ++b)
          if (b != a)
            {
              const double h = shear_factors[a][b];
              TangentTerms::add_product(A,
                                        1.,
                                        M[a][b],
                                        h * principal.values[b] * M[a][b] +
                                          (h * principal.values[a] - tau[a]) *
                                            M[b][a]);
            }
      }
    return A;
  }
} // namespace stickslip
