#include <stickslip/solid/mean_dilatation.h>

#include <stickslip/solid/tangent_terms.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    /// The identity of the first dim directions.
    template <int dim>
    Tensor<2, 3>
    identity_in_space()
    {
      Tensor<2, 3> I;
      for (unsigned int d = 0; d < dim; ++d)
        I[d][d] = 1.;
      return I;
    }



    template <int dim>
    double
    trace_in_space(const Tensor<2, 3> &T)
    {
      double sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        sum += T[d][d];
      return sum;
    }
  } // namespace



  template <int dim>
  MeanDilatation<dim>::MeanDilatation(const bool small_strains)
    : small_strains(small_strains)
  {}



  template <int dim>
  double
  MeanDilatation<dim>::dilatation(const Tensor<2, 3> &F) const
  {
    return small_strains ? trace_in_space<dim>(F) - dim : determinant(F);
  }



  template <int dim>
  Tensor<2, 3>
  MeanDilatation<dim>::derivative(const Tensor<2, 3> &F) const
  {
    if (small_strains)
      return identity_in_space<dim>();
    Tensor<2, 3> result = determinant(F) * transpose(invert(F));
    if (dim == 2)
      result[2][2] = 0.;
    return result;
  }



  template <int dim>
  Tensor<2, 3>
  MeanDilatation<dim>::modified(const Tensor<2, 3> &F, const double mean) const
  {
    if (small_strains)
      return F + ((mean - dilatation(F)) / dim) * identity_in_space<dim>();
    Tensor<2, 3> result = std::pow(mean / determinant(F), 1. / dim) * F;
    if (dim == 2)
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
    const Tensor<2, 3> I = identity_in_space<dim>();
    Response           result;
    result.p = trace_in_space<dim>(P) / dim;
    result.P = P - result.p * I;
    if (A == nullptr)
      return result;

    // A contracted with I/dim on either side
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.row += (*A)[d][d] / dim;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result.column[i][j] += (*A)[i][j][d][d] / dim;
      }
    result.square = trace_in_space<dim>(result.row) / dim;
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
    const double r = std::pow(mean / J, 1. / dim);
    const double c = std::pow(r, 1. - dim);
    Response     result;
    result.P = c * P;
    if (A == nullptr)
      return result;

    // dr = r/dim (M - G : DF) with G = F^-T
    result.A = (c * r) * *A;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        {
          double A_F = 0.;
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int L = 0; L < dim; ++L)
              A_F += (*A)[i][J][k][L] * F[k][L];
          result.column[i][J] = c * (r * A_F + (1. - dim) * P[i][J]) / dim;
        }
    TangentTerms::add_product(result.A, -1., result.column, derivative(F) / J);
    return result;
  }



  template class MeanDilatation<2>;
  template class MeanDilatation<3>;
} // namespace stickslip
