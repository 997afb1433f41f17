#ifndef stickslip_solid_symmetric_maps_h
#define stickslip_solid_symmetric_maps_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace stickslip
{
  /// Linear maps between symmetric tensors, as the tensor of fourth order that
  /// a double contraction applies: the factors of chain rules.
  namespace SymmetricMaps
  {
    using dealii::SymmetricTensor;
    using dealii::Tensor;

    /// Calls entry(i, j, k, l) for the 36 components of a map.
    template <typename Entry>
    SymmetricTensor<4, 3>
    from_entries(const Entry &entry)
    {
      SymmetricTensor<4, 3> map;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = k; l < 3; ++l)
              map[i][j][k][l] = entry(i, j, k, l);
      return map;
    }

    /// Adds H -> factor X (Y:H), as dealii::outer_product() would, which visits
    /// all 81 components.
    inline void
    add_outer_product(SymmetricTensor<4, 3>       &map,
                      const double                 factor,
                      const SymmetricTensor<2, 3> &X,
                      const SymmetricTensor<2, 3> &Y)
    {
      for (unsigned int p = 0; p < 6; ++p)
        {
          const double x = factor * X.access_raw_entry(p);
          for (unsigned int q = 0; q < 6; ++q)
            map.access_raw_entry(6 * p + q) += x * Y.access_raw_entry(q);
        }
    }

    /// H -> Y H Y^T
    inline SymmetricTensor<4, 3>
    congruence(const Tensor<2, 3> &Y)
    {
      return from_entries([&Y](const unsigned int i,
                               const unsigned int j,
                               const unsigned int k,
                               const unsigned int l) {
        return 0.5 * (Y[i][k] * Y[j][l] + Y[i][l] * Y[j][k]);
      });
    }

    /// H -> H X + X^T H
    inline SymmetricTensor<4, 3>
    symmetric_product(const Tensor<2, 3> &X)
    {
      return from_entries([&X](const unsigned int i,
                               const unsigned int j,
                               const unsigned int k,
                               const unsigned int l) {
        return 0.5 * ((i == k ? X[l][j] : 0.) + (i == l ? X[k][j] : 0.) +
                      (j == l ? X[k][i] : 0.) + (j == k ? X[l][i] : 0.));
      });
    }
  } // namespace SymmetricMaps
} // namespace stickslip

#endif
