#include <stickslip/contact/surface/tool_frame.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Newton iterations of a projection. They start from that of the rigid
    /// tool, and there are none where the frame is rigid.
    constexpr unsigned int n_projection_iterations = 20;

    /// Tangential distance that is roundoff, over the distances of the points
    /// and the frame from the origin.
    constexpr double normal_roundoff = 1e-13;



    /// Edges of the simplex of the nodes, as columns.
    template <int dim, typename Position>
    Tensor<2, dim>
    simplex_edges(const std::vector<Position> &nodes)
    {
      Tensor<2, dim> edges;
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int c = 0; c < dim; ++c)
          edges[c][j] = nodes[j + 1][c] - nodes[0][c];
      return edges;
    }
  } // namespace



  template <int dim>
  ToolFrame<dim>::ToolFrame(const std::vector<Point<dim>> &nodes)
    : first_weights(n_nodes, 0.)
    , weight_gradients(n_nodes)
  {
    AssertDimension(nodes.size(), n_nodes);
    const Tensor<2, dim> inverse = invert(simplex_edges<dim>(nodes));
    first_weights[0]             = 1.;
    for (unsigned int j = 0; j < dim; ++j)
      {
        weight_gradients[j + 1] = inverse[j];
        weight_gradients[0] -= inverse[j];
        first_weights[j + 1] = -(inverse[j] * nodes[0]);
        first_weights[0] -= first_weights[j + 1];
      }
  }



  template <int dim>
  void
  ToolFrame<dim>::shape_at(const typename ToolSurface<dim>::Place &place,
                           FaceShapeValues<dim>                   &shape) const
  {
    shape.value.resize(n_nodes);
    shape.gradient.resize(n_nodes);
    shape.hessian.resize(n_nodes);
    for (unsigned int j = 0; j < n_nodes; ++j)
      {
        shape.value[j] = first_weights[j] + weight_gradients[j] * place.x;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            shape.gradient[j][d] = weight_gradients[j] * place.a[d];
            for (unsigned int e = 0; e < dim - 1; ++e)
              shape.hessian[j][d][e] = weight_gradients[j] * place.x_ab[d][e];
          }
      }
  }



  template <int dim>
  Point<dim>
  ToolFrame<dim>::undisplaced(const std::vector<Tensor<1, dim>> &positions,
                              const Tensor<1, dim>              &x) const
  {
    // dx/dX = sum x_j (x) grad weight_j, and x at X = 0
    Tensor<2, dim> F;
    Tensor<1, dim> origin;
    for (unsigned int j = 0; j < n_nodes; ++j)
      {
        F += outer_product(positions[j], weight_gradients[j]);
        origin += first_weights[j] * positions[j];
      }
    return Point<dim>(invert(F) * (x - origin));
  }



  template <int dim>
  void
  evaluate_tool_point(const ToolSurface<dim>            &surface,
                      const ToolFrame<dim>              &frame,
                      const std::vector<Tensor<1, dim>> &positions,
                      const unsigned int                 chart,
                      const Point<dim - 1>              &xi,
                      MasterPoint<dim>                  &point)
  {
    const auto place = surface.evaluate(chart, xi);
    frame.shape_at(place, point.shape);
    evaluate_curved_point(positions,
                          ToolFrame<dim>::n_nodes,
                          place.orientation,
                          point);
  }



  template <int dim>
  typename ToolSurface<dim>::Foot
  project_on_tool(const ToolSurface<dim>            &surface,
                  const ToolFrame<dim>              &frame,
                  const std::vector<Tensor<1, dim>> &positions,
                  const Tensor<1, dim>              &x_s)
  {
    auto foot = surface.closest(frame.undisplaced(positions, x_s));
    if (!foot.found)
      return foot;
    double size = x_s.norm();
    for (const auto &node : positions)
      size = std::max(size, node.norm());
    MasterPoint<dim> at;
    for (unsigned int i = 0; i < n_projection_iterations; ++i)
      {
        evaluate_tool_point(surface, frame, positions, foot.chart, foot.xi, at);
        const Tensor<1, dim> r = x_s - at.x;
        Tensor<1, dim - 1>   slope; // r . a
        Tensor<2, dim - 1>   jacobian;
        bool                 is_normal = true;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            slope[d]  = r * at.a[d];
            is_normal = is_normal && std::abs(slope[d]) <=
                                       normal_roundoff * at.a[d].norm() * size;
            for (unsigned int e = 0; e < dim - 1; ++e)
              jacobian[d][e] = at.a[d] * at.a[e] - r * at.x_ab[d][e];
          }
        if (is_normal)
          return foot;
        foot.xi += invert(jacobian) * slope;
      }
    foot.found = false;
    return foot;
  }

#define INSTANTIATE(dim)                                                 \
  template class ToolFrame<dim>;                                         \
  template void evaluate_tool_point(const ToolSurface<dim> &,            \
                                    const ToolFrame<dim> &,              \
                                    const std::vector<Tensor<1, dim>> &, \
                                    const unsigned int,                  \
                                    const Point<dim - 1> &,              \
                                    MasterPoint<dim> &);                 \
  template typename ToolSurface<dim>::Foot project_on_tool(              \
    const ToolSurface<dim> &,                                            \
    const ToolFrame<dim> &,                                              \
    const std::vector<Tensor<1, dim>> &,                                 \
    const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
