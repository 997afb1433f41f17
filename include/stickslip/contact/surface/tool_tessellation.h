#ifndef stickslip_contact_surface_tool_tessellation_h
#define stickslip_contact_surface_tool_tessellation_h

#include <stickslip/contact/surface/tool_surface.h>

#include <array>
#include <vector>

namespace stickslip
{
  /// Lines (2D) or quadrilaterals that look like the surface of a tool, for
  /// pictures. Vertices of quadrilaterals go around them.
  template <int dim>
  struct ToolTessellation
  {
    static constexpr unsigned int n_vertices = dim == 2 ? 2 : 4;

    std::vector<Point<dim>>                           points;
    std::vector<std::array<unsigned int, n_vertices>> cells;
  };



  /**
   * @p n_per_turn cells go around a full turn, of an arc or about an axis; the
   * points lie on the surface. Quadrilaterals at a pole have two vertices in
   * one place. An extruded surface must end somewhere.
   */
  template <int dim>
  ToolTessellation<dim>
  tessellate(const ToolSurface<dim> &surface, const unsigned int n_per_turn);
} // namespace stickslip

#endif
