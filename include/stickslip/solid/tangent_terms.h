#ifndef stickslip_solid_tangent_terms_h
#define stickslip_solid_tangent_terms_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace stickslip
{
  /**
   * The few products of which the tangents dP_iJ/dF_kL of isotropic laws are
   * sums. The second index of P and F belongs to the undeformed body; G is
   * F^-T.
   */
  namespace TangentTerms
  {
    using dealii::SymmetricTensor;
    using dealii::Tensor;

    /// A_iJkL += factor X_iJ Y_kL
    inline void
    add_product(Tensor<4, 3>       &A,
                const double        factor,
                const Tensor<2, 3> &X,
                const Tensor<2, 3> &Y)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          {
            const double x = factor * X[i][J];
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int L = 0; L < 3; ++L)
                A[i][J][k][L] += x * Y[k][L];
          }
    }

    /// A_iJkL += factor X_iL Y_kJ; with X = Y = G this is minus the
    /// derivative of G.
    inline void
    add_crossed_product(Tensor<4, 3>       &A,
                        const double        factor,
                        const Tensor<2, 3> &X,
                        const Tensor<2, 3> &Y)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double y = factor * Y[k][J];
              for (unsigned int L = 0; L < 3; ++L)
                A[i][J][k][L] += X[i][L] * y;
            }
    }

    /// A_iJkL += delta_ik S_JL, the derivative of F S at a fixed, symmetric S.
    inline void
    add_material(Tensor<4, 3> &A, const Tensor<2, 3> &S)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int L = 0; L < 3; ++L)
            A[i][J][i][L] += S[J][L];
    }

    /// A_iJkL += B_ik delta_JL, the derivative of B F at a fixed B.
    inline void
    add_spatial(Tensor<4, 3> &A, const Tensor<2, 3> &B)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int J = 0; J < 3; ++J)
            A[i][J][k][J] += B[i][k];
    }

    /// A_iJkL += 2 Y_ia W_bJ D_abcd Y_kc W_dL, the derivative of F W S W over F
    /// at a fixed, symmetric W, where S(C) has the derivative D over
    /// C = W F^T F W, and Y = F W.
    inline void
    add_metric_derivative(Tensor<4, 3>                &A,
                          const Tensor<2, 3>          &Y,
                          const Tensor<2, 3>          &W,
                          const SymmetricTensor<4, 3> &D)
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int L = 0; L < 3; ++L)
          {
            SymmetricTensor<2, 3> dC;
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = c; d < 3; ++d)
                dC[c][d] = Y[k][c] * W[d][L] + Y[k][d] * W[c][L];
            const Tensor<2, 3> dP = Y * Tensor<2, 3>(D * dC) * W;
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int J = 0; J < 3; ++J)
                A[i][J][k][L] += dP[i][J];
          }
    }
  } // namespace TangentTerms
} // namespace stickslip

#endif
