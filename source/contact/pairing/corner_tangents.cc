#include <stickslip/contact/pairing/corner_tangents.h>

#include <stickslip/contact/pairing/corner_cone.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Largest cosine of the angle between a cone and a direction that is far
    /// enough from it (18 degrees).
    constexpr double nearest_to_cone = 0.95;

    constexpr unsigned int directions_per_face = 4; // half a turn

    /// Of such cosines: the first direction is as good.
    constexpr double nearly_the_same = 1e-6;



    /// Cosine of the smallest angle between the cone and a line.
    template <int dim>
    double
    nearness(const std::vector<ConeGenerator<dim>> &cone,
             const Tensor<1, dim>                  &direction)
    {
      return std::max(nearest_in_cone(cone, direction).M.norm(),
                      nearest_in_cone(cone, -direction).M.norm());
    }



    Tensor<1, 3>
    unit_direction(const MortarNode<3>              &node,
                   const std::vector<MortarFace<3>> &faces)
    {
      const Tensor<1, 3> direction = tangent_direction<3>(node, faces);
      return direction / direction.norm();
    }



    /// Takes a direction in face @p a, by the angle from its first coordinate.
    void
    set_direction(const FaceShape<3>               &shape,
                  const std::vector<MortarFace<3>> &faces,
                  const unsigned int                a,
                  const double                      angle,
                  MortarNode<3>                    &node)
    {
      const auto &around   = node.faces[a];
      const auto &gradient = shape.at_node(around.displacement).gradient;
      const auto  A =
        surface_tangents<3>(gradient, faces[around.face].positions);
      const Tensor<1, 3> n   = surface_normal<3>(A);
      const Tensor<1, 3> e_1 = A[0] / A[0].norm(),
                         e_2 = cross_product_3d(n / n.norm(), e_1);
      const auto weights =
        direction_weights(gradient,
                          A,
                          std::cos(angle) * e_1 + std::sin(angle) * e_2);
      node.direction_around = a;
      std::fill(node.direction.begin(), node.direction.end(), 0.);
      for (unsigned int k = 0; k < weights.size(); ++k)
        node.direction[around.stencil[k]] = weights[k];
    }



    /// The nodal frames of the friction multipliers are not to turn with the
    /// direction, which was @p before: those of nodes that hang on each other
    /// have to agree.
    void
    keep_nodal_frames(const FaceShape<3>               &shape,
                      const std::vector<MortarFace<3>> &faces,
                      const MortarNode<3>              &node,
                      const Tensor<1, 3>               &before,
                      ContactPoint<3>                  &point)
    {
      const auto           &around = node.faces.front();
      const SurfaceFace<3> &face   = faces[around.face].face;
      const Tensor<1, 3>    v      = outward_normal(
        face,
        surface_tangents<3>(shape.at_node(around.displacement).gradient,
                            face.undeformed_nodes()));
      const Tensor<1, 3> n   = v / v.norm();
      const auto         old = tangent_basis<3>(n, before),
                 now = tangent_basis<3>(n, tangent_direction(node, faces));
      Tensor<2, 2> turn;
      for (unsigned int a = 0; a < 2; ++a)
        for (unsigned int b = 0; b < 2; ++b)
          turn[a][b] = now[a] * old[b];
      for (auto &rotation : point.geometry.reference_rotations)
        rotation = turn * rotation;
      point.nodal_rotations = point.geometry.reference_rotations;
    }



    void
    align(const FaceShape<3>               &shape,
          const std::vector<MortarFace<3>> &faces,
          MortarNode<3>                    &node,
          ContactPoint<3>                  &point)
    {
      if (n_symmetry_planes(node) != 1)
        return;
      const Tensor<1, 3> before = tangent_direction(node, faces);
      // 1 - P = n n
      unsigned int c = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (node.projection[d][d] < node.projection[c][c])
          c = d;
      Tensor<1, 3> normal = -node.projection[c];
      normal[c] += 1.;
      node.fixed_direction = normal / normal.norm();
      std::fill(node.direction.begin(), node.direction.end(), 0.);
      keep_nodal_frames(shape, faces, node, before, point);
    }



    void
    choose(const FaceShape<3>               &shape,
           const std::vector<MortarFace<3>> &faces,
           std::vector<MortarNode<3>>       &nodes,
           std::vector<ContactPoint<3>>     &points)
    {
      AssertDimension(points.size(), nodes.size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          MortarNode<3> &node = nodes[i];
          if (!node.is_corner)
            continue;
          const auto         cone      = cone_of(shape, node, faces);
          const Tensor<1, 3> before    = unit_direction(node, faces);
          double             least     = nearness<3>(cone, before);
          MortarNode<3>      candidate = node;
          if (least < nearest_to_cone)
            continue;
          for (unsigned int a = 0; a < node.faces.size(); ++a)
            for (unsigned int k = 0; k < directions_per_face; ++k)
              {
                set_direction(shape,
                              faces,
                              a,
                              k * numbers::PI / directions_per_face,
                              candidate);
                const double near =
                  nearness<3>(cone, unit_direction(candidate, faces));
                if (near < least - nearly_the_same)
                  {
                    least = near;
                    node  = candidate;
                  }
              }
          keep_nodal_frames(shape, faces, node, before, points[i]);
        }
    }
  } // namespace



  template <int dim>
  void
  align_with_symmetry_plane(const FaceShape<dim>               &shape,
                            const std::vector<MortarFace<dim>> &faces,
                            MortarNode<dim>                    &node,
                            ContactPoint<dim>                  &point)
  {
    if constexpr (dim == 3)
      align(shape, faces, node, point);
    else
      (void)shape, (void)faces, (void)node, (void)point;
  }



  template <int dim>
  void
  choose_tangent_directions(const FaceShape<dim>               &shape,
                            const std::vector<MortarFace<dim>> &faces,
                            std::vector<MortarNode<dim>>       &nodes,
                            std::vector<ContactPoint<dim>>     &points)
  {
    if constexpr (dim == 3)
      choose(shape, faces, nodes, points);
    else
      (void)shape, (void)faces, (void)nodes, (void)points;
  }

#define INSTANTIATE(dim)                   \
  template void align_with_symmetry_plane( \
    const FaceShape<dim> &,                \
    const std::vector<MortarFace<dim>> &,  \
    MortarNode<dim> &,                     \
    ContactPoint<dim> &);                  \
  template void choose_tangent_directions( \
    const FaceShape<dim> &,                \
    const std::vector<MortarFace<dim>> &,  \
    std::vector<MortarNode<dim>> &,        \
    std::vector<ContactPoint<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
