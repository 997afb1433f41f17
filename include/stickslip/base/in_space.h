#ifndef stickslip_base_in_space_h
#define stickslip_base_in_space_h

#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /// A vector or place of a model as one in space: in 2D with a zero.
  template <int dim>
  Tensor<1, 3>
  in_space(const Tensor<1, dim> &v)
  {
    Tensor<1, 3> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = v[d];
    return result;
  }
} // namespace stickslip

#endif
