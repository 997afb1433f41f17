#ifndef stickslip_contact_surface_rigid_tool_h
#define stickslip_contact_surface_rigid_tool_h

#include <stickslip/contact/surface/tool_frame.h>

#include <vector>

namespace stickslip
{
  /// A rigid master surface in closed form and the nodes that it moves with.
  template <int dim>
  struct RigidTool
  {
    ToolSurface<dim> surface;
    /// Of the nodes before the body was scaled, rotated and translated: where
    /// the surface was given.
    ToolFrame<dim> frame;

    /// The surface at xi of @p chart, with the nodes at @p positions.
    void
    evaluate(const std::vector<Tensor<1, dim>> &positions,
             const unsigned int                 chart,
             const Point<dim - 1>              &xi,
             MasterPoint<dim>                  &point) const
    {
      evaluate_tool_point(surface, frame, positions, chart, xi, point);
    }
  };
} // namespace stickslip

#endif
