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



    /// Numbers of the corner nodes of the cells between nodes of a face.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    cells_between_nodes(const FaceShape<dim> &shape)
    {
      if (shape.is_triangle())
        return shape.degree() == 1
                 ? std::vector<std::vector<unsigned int>>{{0, 1, 2}}
                 : std::vector<std::vector<unsigned int>>{{0, 3, 5},
                                                          {3, 1, 4},
                                                          {5, 4, 2},
                                                          {3, 4, 5}};
      std::vector<std::vector<unsigned int>> cells;
      const unsigned int                     degree = shape.degree();
      const unsigned int                     n      = degree + 1;
      if constexpr (dim == 2)
        for (unsigned int i = 0; i < degree; ++i)
          cells.push_back({i, i + 1});
      else
        for (unsigned int j = 0; j < degree; ++j)
          for (unsigned int i = 0; i < degree; ++i)
            cells.push_back(
              {j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i});
      return cells;
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
    std::vector<Point<dim - 1>> nodes;
    for (unsigned int j = 0; j < shape.n_nodes(); ++j)
      nodes.push_back(plane.coordinates(positions[j]));

    ProjectedFace<dim> face;
    face.low = face.high = nodes[0];
    for (const auto &p : nodes)
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          face.low[d]  = std::min(face.low[d], p[d]);
          face.high[d] = std::max(face.high[d], p[d]);
        }
    face.corners = cells_between_nodes(shape);
    for (const auto &corners : face.corners)
      {
        face.cells.emplace_back();
        Point<dim - 1> centre;
        for (const unsigned int j : corners)
          {
            face.cells.back().push_back(nodes[j]);
            centre += Tensor<1, dim - 1>(shape.node(j)) /
                      static_cast<double>(corners.size());
          }
        face.centres.push_back(centre);
      }
    return face;
  }



  template <int dim>
  ParametricMap<dim>::ParametricMap(const FaceShape<dim>     &shape,
                                    const ProjectedFace<dim> &face,
                                    const unsigned int        cell)
    : corner(face.cells[cell][0])
    , xi(shape.node(face.corners[cell][0]))
  {
    const unsigned int n_corners = face.corners[cell].size();
    Tensor<2, dim - 1> in_plane, parametric;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        const unsigned int k = d == 0 ? 1 : n_corners - 1;
        for (unsigned int i = 0; i < dim - 1; ++i)
          {
            in_plane[i][d]   = face.cells[cell][k][i] - corner[i];
            parametric[i][d] = shape.node(face.corners[cell][k])[i] - xi[i];
          }
      }
    if (determinant(in_plane) != 0.)
      slope = parametric * invert(in_plane);
    else
      xi = face.centres[cell];
  }

#define INSTANTIATE(dim)                                                   \
  template class ParametricMap<dim>;                                       \
  template ProjectionPlane<dim> projection_plane(                          \
    const SurfaceFace<dim> &,                                              \
    const FaceShape<dim> &,                                                \
    const std::vector<Tensor<1, dim>> &);                                  \
  template ProjectedFace<dim> project(const FaceShape<dim> &,              \
                                      const std::vector<Tensor<1, dim>> &, \
                                      const ProjectionPlane<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
