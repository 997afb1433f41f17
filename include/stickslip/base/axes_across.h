#ifndef stickslip_base_axes_across_h
#define stickslip_base_axes_across_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>

namespace stickslip
{
  using namespace dealii;

  /// The axis of coordinates that is farthest from the line along @p vector.
  inline Tensor<1, 3>
  farthest_axis(const Tensor<1, 3> &vector)
  {
    unsigned int smallest = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(vector[d]) < std::abs(vector[smallest]))
        smallest = d;
    Tensor<1, 3> axis;
    axis[smallest] = 1.;
    return axis;
  }



  /// Two unit vectors across the unit vector @p axis and each other, by a rule
  /// that depends on the axis alone. Of an axis of another length only the
  /// first one has length 1.
  inline std::array<Tensor<1, 3>, 2>
  axes_across(const Tensor<1, 3> &axis)
  {
    Tensor<1, 3> first = cross_product_3d(axis, farthest_axis(axis));
    first /= first.norm();
    return {{first, cross_product_3d(axis, first)}};
  }
} // namespace stickslip

#endif
