#ifndef stickslip_contact_surface_tool_frame_h
#define stickslip_contact_surface_tool_frame_h

#include <stickslip/contact/surface/master_geometry.h>
#include <stickslip/contact/surface/tool_surface.h>

#include <vector>

namespace stickslip
{
  /**
   * Lets the surface of a rigid tool move with dim + 1 nodes, its frame: a
   * point of the tool is an affine function of them, which is exact for rigid
   * motions. With these weights as shape functions of xi the surface is a
   * master face without facets: gap, slip, virtual work and tangent come out of
   * what there is for faces, and forces on the nodes have the resultant and the
   * moment of those at the points.
   */
  template <int dim>
  class ToolFrame
  {
  public:
    /// The nodes where the surface was given; they must not lie in a plane (2D:
    /// on a line).
    explicit ToolFrame(const std::vector<Point<dim>> &nodes);

    static constexpr unsigned int n_nodes = dim + 1;

    /// Of the nodes, for a point of the undisplaced tool.
    std::vector<double>
    weights(const Point<dim> &X) const
    {
      std::vector<double> weights = first_weights;
      for (unsigned int j = 0; j < n_nodes; ++j)
        weights[j] += weight_gradients[j] * X;
      return weights;
    }

    /// Weights of the nodes, and their derivatives with respect to xi, at a
    /// place on the surface.
    void
    shape_at(const typename ToolSurface<dim>::Place &place,
             FaceShapeValues<dim>                   &shape) const;

    /// The point of the tool that is at @p x where the nodes are at
    /// @p positions, which must not lie in a plane.
    Point<dim>
    undisplaced(const std::vector<Tensor<1, dim>> &positions,
                const Tensor<1, dim>              &x) const;

  private:
    /// Weights are first_weights + weight_gradients X.
    std::vector<double>         first_weights;
    std::vector<Tensor<1, dim>> weight_gradients;
  };



  /**
   * The surface at xi of @p chart with the nodes of the frame at @p positions:
   * position, tangents, curvature and normal into the tool.
   */
  template <int dim>
  void
  evaluate_tool_point(const ToolSurface<dim>            &surface,
                      const ToolFrame<dim>              &frame,
                      const std::vector<Tensor<1, dim>> &positions,
                      const unsigned int                 chart,
                      const Point<dim - 1>              &xi,
                      MasterPoint<dim>                  &point);

  /**
   * Projects @p x_s on the surface with the nodes of the frame at
   * @p positions. Where these have been displaced but not as a rigid body, as
   * between two Newton iterations, x_s - xbar is normal to the surface as it is
   * then.
   */
  template <int dim>
  typename ToolSurface<dim>::Foot
  project_on_tool(const ToolSurface<dim>            &surface,
                  const ToolFrame<dim>              &frame,
                  const std::vector<Tensor<1, dim>> &positions,
                  const Tensor<1, dim>              &x_s);
} // namespace stickslip

#endif
