#include <stickslip/contact/pairing/corner_cone.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Faces whose undeformed normals differ by less (cosine of 30 degrees)
    /// stand for a smooth surface, which has the averaged normal.
    constexpr double sharpest_smooth_kink = 0.866;

    /// A border of a face is one of the surface if no face lies beyond it, as
    /// seen along the direction that leads out of the face (cosine).
    constexpr double beyond_border = 0.2;



    template <int dim>
    Tensor<1, dim>
    unit_normal_at(const FaceShape<dim>              &shape,
                   const SurfaceFace<dim>            &face,
                   const unsigned int                 j,
                   const std::vector<Tensor<1, dim>> &positions)
    {
      const Tensor<1, dim> v = outward_normal(
        face, surface_tangents<dim>(shape.at_node(j).gradient, positions));
      return v / v.norm();
    }



    template <int dim>
    Tensor<1, dim>
    centre_of(const FaceShape<dim>              &shape,
              const std::vector<Tensor<1, dim>> &positions)
    {
      return interpolate<dim>(shape.at_centre().value, positions);
    }



    /// In the face, out of it across the border from node @p j to @p neighbour.
    template <int dim>
    Tensor<1, dim>
    direction_out(const FaceShape<dim>              &shape,
                  const SurfaceFace<dim>            &face,
                  const unsigned int                 j,
                  const unsigned int                 neighbour,
                  const std::vector<Tensor<1, dim>> &positions)
    {
      const Tensor<1, dim> to_centre =
        centre_of(shape, positions) - positions[j];
      Tensor<1, dim>       out = -1. * to_centre;
      const Tensor<1, dim> n   = unit_normal_at(shape, face, j, positions);
      out -= (out * n) * n;
      if (dim == 3)
        {
          Tensor<1, dim> along = positions[neighbour] - positions[j];
          along -= (along * n) * n;
          along /= along.norm();
          out -= (out * along) * along;
        }
      return out / out.norm();
    }



    /// The nodes of a face at the other ends of its borders at node @p j; in 2D
    /// the node itself if it is an end.
    template <int dim>
    std::vector<unsigned int>
    border_neighbours(const FaceShape<dim> &shape, const unsigned int j)
    {
      const Point<dim - 1>     &x = shape.node(j);
      std::vector<unsigned int> result;
      if constexpr (dim == 2)
        {
          if (x[0] == 0. || x[0] == 1.)
            result.push_back(j);
        }
      else
        {
          // the borders are lines on which a coordinate, or on triangles their
          // sum, is constant
          const auto coordinates = [&](const Point<dim - 1> &y) {
            std::vector<double> c = {y[0], y[1]};
            if (shape.is_triangle())
              c.push_back(1. - y[0] - y[1]);
            return c;
          };
          const auto of_j = coordinates(x);
          for (unsigned int d = 0; d < of_j.size(); ++d)
            for (const double end : {0., 1.})
              {
                if (std::abs(of_j[d] - end) > 1e-12 ||
                    (shape.is_triangle() && end == 1.))
                  continue;
                // the farthest node of the line
                unsigned int farthest = j;
                for (unsigned int k = 0; k < shape.n_nodes(); ++k)
                  if (std::abs(coordinates(shape.node(k))[d] - end) < 1e-12 &&
                      shape.node(k).distance(x) >
                        shape.node(farthest).distance(x) + 1e-12)
                    farthest = k;
                result.push_back(farthest);
              }
        }
      return result;
    }



    template <int dim>
    std::vector<Tensor<1, dim>>
    undeformed(const SurfaceFace<dim> &face)
    {
      return {face.reference_positions.begin(),
              face.reference_positions.begin() + face.n_nodes};
    }



    /// True if another face around the node has the border, or lies beyond it.
    template <int dim>
    bool
    goes_on(const FaceShape<dim>               &shape,
            const MortarNode<dim>              &node,
            const std::vector<MortarFace<dim>> &faces,
            const unsigned int                  around,
            const unsigned int                  neighbour)
    {
      const auto             &own       = node.faces[around];
      const SurfaceFace<dim> &face      = faces[own.face].face;
      const auto              key       = face.dofs[neighbour * dim];
      const auto              positions = undeformed(face);
      const Tensor<1, dim>    out =
        direction_out(shape, face, own.displacement, neighbour, positions);
      for (unsigned int b = 0; b < node.faces.size(); ++b)
        if (b != around)
          {
            const SurfaceFace<dim> &other = faces[node.faces[b].face].face;
            for (unsigned int k = 0; k < other.n_nodes; ++k)
              if (other.dofs[k * dim] == key)
                return true;
            const Tensor<1, dim> there =
              centre_of(shape, undeformed(other)) - positions[own.displacement];
            if (there * out > beyond_border * there.norm())
              return true;
          }
      return false;
    }



    /// The direction out of a face with its derivative. It is the tangent in
    /// 2D; in 3D b x n with the line b to the neighbour on the border.
    template <int dim>
    ConeGenerator<dim>
    border_generator(const FaceShape<dim>              &shape,
                     const SurfaceFace<dim>            &face,
                     const unsigned int                 j,
                     const unsigned int                 neighbour,
                     const std::vector<Tensor<1, dim>> &positions)
    {
      ConeGenerator<dim>   result;
      const Tensor<1, dim> out =
        direction_out(shape, face, j, neighbour, positions);
      const auto &values = shape.at_node(j);
      const auto  a      = surface_tangents<dim>(values.gradient, positions);
      result.derivative.resize(face.n_nodes);
      Tensor<1, dim> v;
      if constexpr (dim == 2)
        {
          v = a[0];
          for (unsigned int k = 0; k < face.n_nodes; ++k)
            result.derivative[k] = values.gradient[k][0] *
                                   Tensor<2, dim>(unit_symmetric_tensor<dim>());
        }
      else
        {
          const Tensor<1, dim> n =
            outward_normal(face, a) / outward_normal(face, a).norm();
          const Tensor<1, dim> b = positions[neighbour] - positions[j];
          v                      = cross_product_3d(b, n);
          const auto D_n = outward_normal_derivative(face, positions, values);
          for (unsigned int k = 0; k < face.n_nodes; ++k)
            for (unsigned int c = 0; c < dim; ++c)
              {
                Tensor<1, dim> e, column;
                e[c] = (k == neighbour ? 1. : 0.) - (k == j ? 1. : 0.);
                for (unsigned int i = 0; i < dim; ++i)
                  column[i] = D_n[k][i][c];
                column = cross_product_3d(e, n) + cross_product_3d(b, column);
                for (unsigned int i = 0; i < dim; ++i)
                  result.derivative[k][i][c] = column[i];
              }
        }
      const double sign = v * out < 0. ? -1. : 1.;
      result.direction  = sign / v.norm() * v;
      for (auto &derivative : result.derivative)
        derivative = sign * unit_vector_derivative(v) * derivative;
      return result;
    }



    /// Shares of generators in the vector of their span that is nearest to
    /// @p target; empty if one of them is negative.
    template <int dim>
    std::vector<double>
    shares_in_span(const std::vector<ConeGenerator<dim>> &cone,
                   const std::vector<unsigned int>       &chosen,
                   const Tensor<1, dim>                  &target)
    {
      const Tensor<1, dim> &g = cone[chosen[0]].direction;
      std::vector<double>   shares;
      if (chosen.size() == 1)
        shares = {g * target};
      else
        {
          const Tensor<1, dim> &h           = cone[chosen[1]].direction;
          const double          determinant = 1. - (g * h) * (g * h);
          if (determinant < 1e-14)
            return {};
          shares = {(g * target - (g * h) * (h * target)) / determinant,
                    (h * target - (g * h) * (g * target)) / determinant};
        }
      for (const double share : shares)
        if (share < 0.)
          return {};
      return shares;
    }



    /// True if no generator leads from @p M nearer to @p target.
    template <int dim>
    bool
    is_nearest(const std::vector<ConeGenerator<dim>> &cone,
               const Tensor<1, dim>                  &M,
               const Tensor<1, dim>                  &target)
    {
      return std::all_of(cone.begin(), cone.end(), [&](const auto &generator) {
        return generator.direction * (target - M) < 1e-12;
      });
    }



    /// The generators of the side of @p cone that is nearest to @p target: none
    /// if the target is inside.
    template <int dim>
    std::vector<unsigned int>
    nearest_side(const std::vector<ConeGenerator<dim>> &cone,
                 const Tensor<1, dim>                  &target)
    {
      std::vector<std::vector<unsigned int>> sides;
      for (unsigned int i = 0; i < cone.size(); ++i)
        sides.push_back({i});
      for (unsigned int i = 0; i < cone.size() && dim == 3; ++i)
        for (unsigned int j = 0; j < i; ++j)
          sides.push_back({i, j});
      for (const auto &side : sides)
        {
          const auto     shares = shares_in_span(cone, side, target);
          Tensor<1, dim> M;
          for (unsigned int i = 0; i < shares.size(); ++i)
            M += shares[i] * cone[side[i]].direction;
          if (!shares.empty() && is_nearest(cone, M, target))
            return side;
        }
      return {};
    }
  } // namespace



  template <int dim>
  void
  find_corners(const FaceShape<dim>               &shape,
               const std::vector<MortarFace<dim>> &faces,
               std::vector<MortarNode<dim>>       &nodes)
  {
    for (MortarNode<dim> &node : nodes)
      {
        std::vector<Tensor<1, dim>> normals;
        for (const auto &around : node.faces)
          {
            const SurfaceFace<dim> &face = faces[around.face].face;
            normals.push_back(unit_normal_at(
              shape, face, around.displacement, undeformed(face)));
            for (const Tensor<1, dim> &other : normals)
              if (normals.back() * other < sharpest_smooth_kink)
                node.corner.is_corner = true;
          }
        for (unsigned int a = 0; a < node.faces.size(); ++a)
          for (const unsigned int neighbour :
               border_neighbours(shape, node.faces[a].displacement))
            // in 2D an end has no other face
            if (dim == 2 ? node.faces.size() == 1
                         : !goes_on(shape, node, faces, a, neighbour))
              node.corner.borders.push_back({a, neighbour});
        if (!node.corner.borders.empty())
          node.corner.is_corner = true;
      }
  }



  template <int dim>
  std::vector<ConeGenerator<dim>>
  cone_of(const FaceShape<dim>               &shape,
          const MortarNode<dim>              &node,
          const std::vector<MortarFace<dim>> &faces)
  {
    std::vector<ConeGenerator<dim>> cone;
    for (unsigned int a = 0; a < node.faces.size(); ++a)
      {
        const auto            &around = node.faces[a];
        const MortarFace<dim> &slave  = faces[around.face];
        cone.push_back(
          {unit_normal_at(
             shape, slave.face, around.displacement, slave.positions),
           a,
           outward_normal_derivative(slave.face,
                                     slave.positions,
                                     shape.at_node(around.displacement))});
      }
    for (const auto &border : node.corner.borders)
      {
        const auto            &around = node.faces[border.around];
        const MortarFace<dim> &slave  = faces[around.face];
        cone.push_back(border_generator(shape,
                                        slave.face,
                                        around.displacement,
                                        border.neighbour,
                                        slave.positions));
        cone.back().around = border.around;
      }
    return cone;
  }



  template <int dim>
  NearestInCone<dim>
  nearest_in_cone(const std::vector<ConeGenerator<dim>> &cone,
                  const Tensor<1, dim>                  &target)
  {
    NearestInCone<dim> result;
    if (is_nearest(cone, Tensor<1, dim>(), target))
      return result;
    const auto side = nearest_side(cone, target);
    if (side.empty())
      result.M = target;
    else
      result.shares = shares_in_span(cone, side, target);
    for (unsigned int i = 0; i < side.size(); ++i)
      {
        result.side.push_back(cone[side[i]]);
        result.M += result.shares[i] * cone[side[i]].direction;
      }
    return result;
  }

#define INSTANTIATE(dim)                                                                      \
  template void                            find_corners(const FaceShape<dim> &,               \
                                                        const std::vector<MortarFace<dim>> &, \
                                                        std::vector<MortarNode<dim>> &);      \
  template std::vector<ConeGenerator<dim>> cone_of(                                           \
    const FaceShape<dim> &,                                                                   \
    const MortarNode<dim> &,                                                                  \
    const std::vector<MortarFace<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
