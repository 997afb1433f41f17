#ifndef stickslip_solid_direction_parameters_h
#define stickslip_solid_direction_parameters_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <utility>

namespace stickslip
{
  using namespace dealii;

  /// Axis (of unit length; z in 2D) and centre of a rotation or of cylindrical
  /// components, from "Rotation axis" and "Rotation centre". Throws UserError
  /// naming the parameter below @p path.
  template <int dim>
  std::pair<Tensor<1, 3>, Point<dim>>
  axis_of(const std::string &rotation_axis,
          const std::string &rotation_centre,
          const std::string &path);

  /**
   * A vector from a parameter: a letter x, y, z for a unit vector, or @p dim
   * numbers separated by commas. Throws UserError naming @p path.
   */
  template <int dim>
  Tensor<1, dim>
  vector_from_parameter(const std::string &text, const std::string &path);
} // namespace stickslip

#endif
