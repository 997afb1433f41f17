#include <stickslip/contact/surface/projected_face.h>

#include <stickslip/base/axes_across.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stickslip
{
  namespace
  {
    /// A unit vector normal to @p n, by a rule that depends on n alone.
    Tensor<1, 3>
    tangent_to(const Tensor<1, 3> &n)
    {
      const Tensor<1, 3> axis = farthest_axis(n);
      const Tensor<1, 3> t    = axis - (axis * n) * n;
      return t / t.norm();
    }



    /// Coordinates s with edges * s + twist * s_0 s_1 = @p place, by Newton's
    /// method from @p s; none if it does not converge.
    std::optional<Tensor<1, 2>>
    bilinear_inverse(const Tensor<1, 2> &place,
                     const Tensor<2, 2> &edges,
                     const Tensor<1, 2> &twist,
                     Tensor<1, 2>        s)
    {
      constexpr unsigned int most_iterations = 8;
      constexpr double       small_step = 1e-8; // the next one is its square
      for (unsigned int i = 0; i < most_iterations; ++i)
        {
          Tensor<2, 2> slope = edges;
          for (unsigned int c = 0; c < 2; ++c)
            {
              slope[c][0] += s[1] * twist[c];
              slope[c][1] += s[0] * twist[c];
            }
          if (determinant(slope) == 0.)
            return {};
          const Tensor<1, 2> step =
            invert(slope) * (place - edges * s - s[0] * s[1] * twist);
          s += step;
          if (step.norm() < small_step)
            return s;
        }
      return {};
    }
  } // namespace



  template <int dim>
  ProjectionPlane<dim>
  projection_plane(const SurfaceFace<dim>            &slave,
                   const FaceShape<dim>              &shape,
                   const std::vector<Tensor<1, dim>> &positions)
  {
    const FaceShapeValues<dim> &values = shape.at_centre();
    const auto a = surface_tangents<dim>(values.gradient, positions);

    ProjectionPlane<dim> plane;
    plane.origin = interpolate<dim>(values.value, positions);
    plane.n      = -slave.orientation * surface_normal<dim>(a);
    plane.n /= plane.n.norm();
    if constexpr (dim == 2)
      plane.e[0] = Tensor<1, 2>({-plane.n[1], plane.n[0]});
    else
      {
        plane.e[0] = tangent_to(plane.n);
        plane.e[1] = cross_product_3d(plane.n, plane.e[0]);
      }
    return plane;
  }



  template <int dim>
  ProjectedFace<dim>
  project(const FaceShape<dim>              &shape,
          const std::vector<Tensor<1, dim>> &positions,
          const ProjectionPlane<dim>        &plane)
  {
    ProjectedFace<dim> face;
    face.low = face.high = plane.coordinates(positions[0]);
    for (const auto &cell : shape.cells())
      {
        face.cells.emplace_back();
        for (const unsigned int j : cell.corners)
          {
            const Point<dim - 1> p = plane.coordinates(positions[j]);
            face.cells.back().push_back(p);
            for (unsigned int d = 0; d < dim - 1; ++d)
              {
                face.low[d]  = std::min(face.low[d], p[d]);
                face.high[d] = std::max(face.high[d], p[d]);
              }
          }
      }
    return face;
  }



  template <int dim>
  bool
  may_meet(const ProjectedFace<dim>          &face,
           const ProjectionPlane<dim>        &plane,
           const std::vector<Tensor<1, dim>> &positions,
           const unsigned int                 n_nodes)
  {
    Point<dim - 1> low  = plane.coordinates(positions[0]);
    Point<dim - 1> high = low;
    for (unsigned int j = 1; j < n_nodes; ++j)
      {
        const Point<dim - 1> p = plane.coordinates(positions[j]);
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            low[d]  = std::min(low[d], p[d]);
            high[d] = std::max(high[d], p[d]);
          }
      }
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (low[d] >= face.high[d] || face.low[d] >= high[d])
        return false;
    return true;
  }



  template <int dim>
  ParametricMap<dim>::ParametricMap(const FaceShape<dim>     &shape,
                                    const ProjectedFace<dim> &face,
                                    const unsigned int        cell)
    : corner(face.cells[cell][0])
    , first(shape.node(shape.cells()[cell].corners[0]))
  {
    const auto        &corners   = shape.cells()[cell].corners;
    const unsigned int n_corners = corners.size();
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        const unsigned int k = d == 0 ? 1 : n_corners - 1;
        for (unsigned int i = 0; i < dim - 1; ++i)
          {
            edges[i][d]  = face.cells[cell][k][i] - corner[i];
            extent[i][d] = shape.node(corners[k])[i] - first[i];
          }
      }
    if (determinant(edges) == 0.)
      {
        first  = shape.cells()[cell].centre;
        extent = 0.;
        return;
      }
    inverse_edges = invert(edges);
    if (n_corners == 4)
      twist = (face.cells[cell][2] - face.cells[cell][1]) -
              (face.cells[cell][3] - corner);
  }



  template <int dim>
  Point<dim - 1>
  ParametricMap<dim>::at(const Point<dim - 1> &p) const
  {
    Tensor<1, dim - 1> s = inverse_edges * (p - corner);
    if constexpr (dim == 3)
      if (twist != Tensor<1, 2>())
        s = bilinear_inverse(p - corner, edges, twist, s).value_or(s);
    return first + extent * s;
  }



#define INSTANTIATE(dim)                                                      \
  template class ParametricMap<dim>;                                          \
  template bool                 may_meet(const ProjectedFace<dim> &,          \
                                         const ProjectionPlane<dim> &,        \
                                         const std::vector<Tensor<1, dim>> &, \
                                         const unsigned int);                 \
  template ProjectionPlane<dim> projection_plane(                             \
    const SurfaceFace<dim> &,                                                 \
    const FaceShape<dim> &,                                                   \
    const std::vector<Tensor<1, dim>> &);                                     \
  template ProjectedFace<dim> project(const FaceShape<dim> &,                 \
                                      const std::vector<Tensor<1, dim>> &,    \
                                      const ProjectionPlane<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
