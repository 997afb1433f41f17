#include <stickslip/contact/surface/projected_face.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// A unit vector normal to @p n, by a rule that depends on n alone.
    Tensor<1, 3>
    tangent_to(const Tensor<1, 3> &n)
    {
      unsigned int smallest = 0;
      for (unsigned int c = 1; c < 3; ++c)
        if (std::abs(n[c]) < std::abs(n[smallest]))
          smallest = c;
      Tensor<1, 3> axis;
      axis[smallest]       = 1.;
      const Tensor<1, 3> t = axis - (axis * n) * n;
      return t / t.norm();
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
    , xi(shape.node(shape.cells()[cell].corners[0]))
  {
    const auto        &corners   = shape.cells()[cell].corners;
    const unsigned int n_corners = corners.size();
    Tensor<2, dim - 1> in_plane, parametric;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        const unsigned int k = d == 0 ? 1 : n_corners - 1;
        for (unsigned int i = 0; i < dim - 1; ++i)
          {
            in_plane[i][d]   = face.cells[cell][k][i] - corner[i];
            parametric[i][d] = shape.node(corners[k])[i] - xi[i];
          }
      }
    if (determinant(in_plane) != 0.)
      slope = parametric * invert(in_plane);
    else
      xi = shape.cells()[cell].centre;
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
