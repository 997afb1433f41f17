#ifndef stickslip_contact_surface_tool_shapes_h
#define stickslip_contact_surface_tool_shapes_h

#include <stickslip/contact/surface/tool_surface.h>

#include <string>

namespace stickslip
{
  /// The side of a round surface that the tool is on.
  enum class ToolSide
  {
    inside, ///< a shaft, a ball
    around  ///< a bush, a socket
  };

  /*
   * Tools that have names. All of them throw UserError (same on all ranks) with
   * the name @p path of the parameter if a length is not positive or an angle
   * impossible. Directions need not have length 1.
   */

  /// A square (2D: a line) of the edge length @p size; @p outward points out of
  /// the tool. Beyond its edges there is no tool.
  template <int dim>
  ToolSurface<dim>
  make_plane(const Point<dim>     &centre,
             const Tensor<1, dim> &outward,
             const double          size,
             const std::string    &path);

  /// A circle: what a cylinder is in two dimensions.
  ToolSurface<2>
  make_circle(const Point<2>    &centre,
              const double       radius,
              const ToolSide     side,
              const std::string &path);

  /// The round side of a cylinder of the length @p length around @p centre.
  /// Beyond its ends there is no tool.
  ToolSurface<3>
  make_cylinder(const Point<3>     &centre,
                const Tensor<1, 3> &axis,
                const double        radius,
                const double        length,
                const ToolSide      side,
                const std::string  &path);

  /// All of a cylinder, with flat ends and edges rounded by @p edge_radius.
  ToolSurface<3>
  make_rounded_cylinder(const Point<3>     &centre,
                        const Tensor<1, 3> &axis,
                        const double        radius,
                        const double        length,
                        const double        edge_radius,
                        const std::string  &path);

  ToolSurface<3>
  make_sphere(const Point<3>    &centre,
              const double       radius,
              const ToolSide     side,
              const std::string &path);

  /// A cone that opens along @p axis from its @p tip, which a ball of the
  /// radius @p tip_radius rounds from the inside. Beyond @p height, measured
  /// from the sharp tip, there is no tool. @p half_angle in degrees.
  ToolSurface<3>
  make_cone(const Point<3>     &tip,
            const Tensor<1, 3> &axis,
            const double        half_angle,
            const double        height,
            const double        tip_radius,
            const std::string  &path);

  /// A ring whose centre line has the radius @p radius, of the thickness
  /// 2 @p tube_radius.
  ToolSurface<3>
  make_torus(const Point<3>     &centre,
             const Tensor<1, 3> &axis,
             const double        radius,
             const double        tube_radius,
             const ToolSide      side,
             const std::string  &path);
} // namespace stickslip

#endif
