#include <stickslip/solid/tangent_products.h>

#include <stickslip/base/vectorized.h>

#include <type_traits>

namespace stickslip
{
  namespace
  {
    struct Single
    {
      using Lanes = double;

      [[gnu::always_inline]] static double
      load(const double *const x)
      {
        return *x;
      }

      [[gnu::always_inline]] static void
      store(double *const x, const double value)
      {
        *x = value;
      }
    };



    /// The columns [b, b + lanes of @p Block) of the rows (a, i) for all k:
    /// gradients are read once for these.
    template <typename Block, int dim>
    [[gnu::always_inline]] inline void
    add_columns(const unsigned int  n,
                const double *const G,
                const double (&G_A)[dim][dim],
                double *const K)
    {
      typename Block::Lanes G_b[dim];
      for (unsigned int L = 0; L < dim; ++L)
        G_b[L] = Block::load(G + L * n);
      for (unsigned int k = 0; k < dim; ++k)
        {
          typename Block::Lanes sum = Block::load(K + k * n);
          for (unsigned int L = 0; L < dim; ++L)
            sum += G_A[k][L] * G_b[L];
          Block::store(K + k * n, sum);
        }
    }



    /// K_(a i)(k b) += G_aJ A_iJkL G_bL for @p n nodes.
    template <int dim, typename Number>
    [[gnu::always_inline]] inline void
    add_rows(const Number        n,
             const double *const G,
             const double (&A)[dim][dim][dim][dim],
             double *const K)
    {
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          {
            double G_A[dim][dim]; // G_aJ A_iJkL for this a and i
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int L = 0; L < dim; ++L)
                {
                  G_A[k][L] = 0.;
                  for (unsigned int J = 0; J < dim; ++J)
                    G_A[k][L] += G[J * n + a] * A[i][J][k][L];
                }
            double *const row = K + (a * dim + i) * dim * n;
            unsigned int  b   = 0;
            for (; b + 4 <= n; b += 4)
              add_columns<FourLanes, dim>(n, G + b, G_A, row + b);
            for (; b < n; ++b)
              add_columns<Single, dim>(n, G + b, G_A, row + b);
          }
    }



    template <int dim>
    [[gnu::always_inline]] inline void
    add_all_rows(const unsigned int  n,
                 const double *const G,
                 const double (&A)[dim][dim][dim][dim],
                 double *const K)
    {
      // Loops of a length that the compiler knows are faster.
      constexpr unsigned int linear            = 1 << dim;
      constexpr unsigned int quadratic         = dim == 2 ? 9 : 27;
      constexpr unsigned int simplex           = dim + 1;
      constexpr unsigned int quadratic_simplex = (dim + 1) * (dim + 2) / 2;
      const auto add = [&](const auto length) __attribute__((always_inline))
      {
        add_rows<dim>(length, G, A, K);
      };
      if (n == linear)
        add(std::integral_constant<unsigned int, linear>());
      else if (n == quadratic)
        add(std::integral_constant<unsigned int, quadratic>());
      else if (n == simplex)
        add(std::integral_constant<unsigned int, simplex>());
      else if (n == quadratic_simplex)
        add(std::integral_constant<unsigned int, quadratic_simplex>());
      else
        add(n);
    }
  } // namespace



  STICKSLIP_VECTORIZED void
  add_tangent_products(const unsigned int  n,
                       const double *const G,
                       const double (&A)[2][2][2][2],
                       double *const K)
  {
    add_all_rows(n, G, A, K);
  }



  STICKSLIP_VECTORIZED void
  add_tangent_products(const unsigned int  n,
                       const double *const G,
                       const double (&A)[3][3][3][3],
                       double *const K)
  {
    add_all_rows(n, G, A, K);
  }
} // namespace stickslip
