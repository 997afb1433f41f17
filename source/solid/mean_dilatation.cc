#include <stickslip/solid/mean_dilatation.h>

#include <stickslip/solid/tangent_terms.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    /// The identity of the first @p n directions.
    Tensor<2, 3>
    identity_of(const unsigned int n)
    {
      Tensor<2, 3> I;
      for (unsigned int d = 0; d < n; ++d)
        I[d][d] = 1.;
      return I;
    }



    double
    trace_of(const unsigned int n, const Tensor<2, 3> &T)
    {
      double sum = 0.;
      for (unsigned int d = 0; d < n; ++d)
        sum += T[d][d];
      return sum;
    }
  } // namespace



  template <int dim>
  MeanDilatation<dim>::MeanDilatation(const bool         small_strains,
                                      const unsigned int n_directions)
    : small_strains(small_strains)
    , n(n_directions)
  {}



  template <int dim>
  double
  MeanDilatation<dim>::dilatation(const Tensor<2, 3> &F) const
  {
    return small_strains ? trace_of(n, F) - n : determinant(F);
  }



  template <int dim>
  Tensor<2, 3>
  MeanDilatation<dim>::derivative(const Tensor<2, 3> &F) const
  {
    if (small_strains)
      return identity_of(n);
    Tensor<2, 3> result = determinant(F) * transpose(invert(F));
    if (n == 2)
      result[2][2] = 0.;
    return result;
  }



  template <int dim>
  Tensor<2, 3>
  MeanDilatation<dim>::modified(const Tensor<2, 3> &F, const double mean) const
  {
    if (small_strains)
      return F + ((mean - dilatation(F)) / n) * identity_of(n);
    Tensor<2, 3> result = std::pow(mean / determinant(F), 1. / n) * F;
    if (n == 2)
      result[2][2] = F[2][2];
    return result;
  }



  template <int dim>
  typename MeanDilatation<dim>::Response
  MeanDilatation<dim>::response(const Tensor<2, 3> &F,
                                const double        mean,
                                const Tensor<2, 3> &P,
                                const Tensor<4, 3> *A) const
  {
    return small_strains ? small_response(P, A) : large_response(F, mean, P, A);
  }



  template <int dim>
  typename MeanDilatation<dim>::Response
  MeanDilatation<dim>::small_response(const Tensor<2, 3> &P,
                                      const Tensor<4, 3> *A) const
  {
    const Tensor<2, 3> I = identity_of(n);
    Response           result;
    result.p = trace_of(n, P) / n;
    result.P = P - result.p * I;
    if (A == nullptr)
      return result;

    // A contracted with I/n on either side
    for (unsigned int d = 0; d < n; ++d)
      {
        result.row += (*A)[d][d] / n;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result.column[i][j] += (*A)[i][j][d][d] / n;
      }
    result.square = trace_of(n, result.row) / n;
    result.A      = *A;
    TangentTerms::add_product(result.A, -1., I, result.row);
    TangentTerms::add_product(result.A, -1., result.column, I);
    TangentTerms::add_product(result.A, result.square, I, I);
    result.row -= result.square * I;
    result.column -= result.square * I;
    return result;
  }



  template <int dim>
  typename MeanDilatation<dim>::Response
  MeanDilatation<dim>::large_response(const Tensor<2, 3> &F,
                                      const double        mean,
                                      const Tensor<2, 3> &P,
                                      const Tensor<4, 3> *A) const
  {
    const double J = determinant(F);
    const double r = std::pow(mean / J, 1. / n);
    const double c = std::pow(r, 1. - n);
    Response     result;
    result.P = c * P;
    if (A == nullptr)
      return result;

    // dr = r/n (M - G : DF) with G = F^-T
    result.A = (c * r) * *A;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        {
          double A_F = 0.;
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int L = 0; L < n; ++L)
              A_F += (*A)[i][J][k][L] * F[k][L];
          result.column[i][J] = c * (r * A_F + (1. - n) * P[i][J]) / n;
        }
    TangentTerms::add_product(result.A, -1., result.column, derivative(F) / J);
    return result;
  }



  template class MeanDilatation<2>;
  template class MeanDilatation<3>;
} // namespace stickslip
