#include <stickslip/contact/pairing/corner_cone.h>

#include <stickslip/contact/pairing/surface_borders.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Faces whose undeformed normals differ by less (cosine of 30 degrees)
    /// stand for a smooth surface, which has the averaged normal.
    constexpr double sharpest_smooth_kink = 0.866;



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



    /// An edge that leaves the symmetry planes by less than this share of its
    /// length lies in them.
    constexpr double same_plane = 1e-6;



    template <int dim>
    std::vector<Tensor<1, dim>>
    undeformed_normals(const FaceShape<dim>               &shape,
                       const std::vector<MortarFace<dim>> &faces,
                       const MortarNode<dim>              &node)
    {
      std::vector<Tensor<1, dim>> normals;
      for (const auto &around : node.faces)
        {
          const SurfaceFace<dim> &face = faces[around.face].face;
          normals.push_back(unit_normal_at(
            shape, face, around.displacement, face.undeformed_nodes()));
        }
      return normals;
    }



    template <int dim>
    bool
    have_kink(const std::vector<Tensor<1, dim>> &normals)
    {
      for (const auto &a : normals)
        for (const auto &b : normals)
          if (a * b < sharpest_smooth_kink * a.norm() * b.norm())
            return true;
      return false;
    }



    /// Directions that lie closer together than this span nothing.
    constexpr double same_direction = 1e-12;



    /**
     * The dual basis of some generators in their span: its products with them
     * are 1 and 0. Empty if they are not independent. Exact to roundoff also
     * for nearly parallel ones, as the normals of a nearly flat surface are.
     */
    template <int dim>
    std::vector<Tensor<1, dim>>
    dual_basis(const std::vector<Tensor<1, dim>> &g)
    {
      if (g.size() == 1)
        return g;
      if (g.size() == 2)
        {
          Tensor<1, dim> across = g[1] - g[0];
          across -= (across * g[0]) * g[0];
          if (across.norm() < same_direction)
            return {};
          across /= across.norm_square();
          return {g[0] - (g[0] * g[1]) * across, across};
        }
      if constexpr (dim == 3)
        {
          const std::vector<Tensor<1, dim>> normals{
            cross_product_3d(g[1], g[2]),
            cross_product_3d(g[2], g[0]),
            cross_product_3d(g[0], g[1])};
          const double volume = normals[0] * g[0];
          if (std::abs(volume) > same_direction)
            return {normals[0] / volume,
                    normals[1] / volume,
                    normals[2] / volume};
        }
      return {};
    }



    /// A generator as the half that is there has it.
    template <int dim>
    Tensor<1, dim>
    direction_of(const FaceShape<dim>               &shape,
                 const MortarNode<dim>              &node,
                 const std::vector<MortarFace<dim>> &faces,
                 const ConeGenerator<dim>           &generator)
    {
      const auto            &around = node.faces[generator.around];
      const MortarFace<dim> &slave  = faces[around.face];
      return generator.neighbour ? direction_out(shape,
                                                 slave.face,
                                                 around.displacement,
                                                 *generator.neighbour,
                                                 slave.positions)
                                 : unit_normal_at(shape,
                                                  slave.face,
                                                  around.displacement,
                                                  slave.positions);
    }



    /// All choices of 1 to dim of @p n things.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    choices(const unsigned int n)
    {
      std::vector<std::vector<unsigned int>> result;
      for (unsigned int i = 0; i < n; ++i)
        {
          result.push_back({i});
          for (unsigned int j = 0; j < i; ++j)
            {
              result.push_back({i, j});
              for (unsigned int k = 0; k < j && dim == 3; ++k)
                result.push_back({i, j, k});
            }
        }
      return result;
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
        node.borders   = find_borders(shape, node, faces);
        node.is_corner = !node.borders.empty() ||
                         have_kink(undeformed_normals(shape, faces, node));
      }
  }



  template <int dim>
  void
  restrict_to_symmetry_planes(const FaceShape<dim>               &shape,
                              const std::vector<MortarFace<dim>> &faces,
                              MortarNode<dim>                    &node)
  {
    if (!node.is_corner || n_symmetry_planes(node) == 0)
      return;
    const auto is_in_plane = [&](
                               const typename MortarNode<dim>::Border &border) {
      const auto          &around = node.faces[border.around];
      const auto          &nodes  = faces[around.face].face.reference_positions;
      const Tensor<1, dim> edge =
        nodes[border.neighbour] - nodes[around.displacement];
      return (edge - node.projection * edge).norm() < same_plane * edge.norm();
    };
    node.borders.erase(std::remove_if(node.borders.begin(),
                                      node.borders.end(),
                                      is_in_plane),
                       node.borders.end());
    auto normals = undeformed_normals(shape, faces, node);
    for (auto &n : normals)
      n = node.projection * n;
    node.is_corner = n_symmetry_planes(node) < dim - 1 &&
                     (!node.borders.empty() || have_kink(normals));
  }



  template <int dim>
  std::vector<ConeGenerator<dim>>
  cone_of(const FaceShape<dim>               &shape,
          const MortarNode<dim>              &node,
          const std::vector<MortarFace<dim>> &faces)
  {
    std::vector<ConeGenerator<dim>> cone;
    const auto add = [&](const ConeGenerator<dim> &generator) {
      const Tensor<1, dim> direction =
        node.projection * direction_of(shape, node, faces, generator);
      if (direction.norm() > same_direction) // else across the planes
        {
          cone.push_back(generator);
          cone.back().direction = direction / direction.norm();
        }
    };
    for (unsigned int a = 0; a < node.faces.size(); ++a)
      add({{}, a, {}});
    for (const auto &border : node.borders)
      add({{}, border.around, border.neighbour});
    return cone;
  }



  template <int dim>
  std::vector<Tensor<2, dim>>
  generator_derivative(const FaceShape<dim>               &shape,
                       const MortarNode<dim>              &node,
                       const std::vector<MortarFace<dim>> &faces,
                       const ConeGenerator<dim>           &generator)
  {
    const auto            &around = node.faces[generator.around];
    const MortarFace<dim> &slave  = faces[around.face];
    auto                   derivative =
      generator.neighbour
                          ? direction_out_derivative(shape,
                                   slave.face,
                                   around.displacement,
                                   *generator.neighbour,
                                   slave.positions)
                          : outward_normal_derivative(slave.face,
                                    slave.positions,
                                    shape.at_node(around.displacement));
    const Tensor<2, dim> in_planes =
      unit_vector_derivative(node.projection *
                             direction_of(shape, node, faces, generator)) *
      node.projection;
    for (auto &of_node : derivative)
      of_node = in_planes * of_node; // of unit vectors, without planes the same
    return derivative;
  }



  template <int dim>
  NearestInCone<dim>
  nearest_in_cone(const std::vector<ConeGenerator<dim>> &cone,
                  const Tensor<1, dim>                  &target)
  {
    // The nearest of the feet of the perpendiculars onto the sides, that is of
    // the projections onto spans of generators with no negative share. That it
    // is the nearest, and not only that a condition holds within a tolerance,
    // makes it continuous.
    NearestInCone<dim> result;
    double             least = target.norm();
    for (const auto &choice : choices<dim>(cone.size()))
      {
        std::vector<Tensor<1, dim>> directions(choice.size());
        for (unsigned int i = 0; i < choice.size(); ++i)
          directions[i] = cone[choice[i]].direction;
        const auto duals = dual_basis<dim>(directions);
        if (duals.empty() ||
            std::any_of(duals.begin(), duals.end(), [&](const auto &dual) {
              return dual * target < 0.;
            }))
          continue;
        if (choice.size() == dim)
          return {target, {}, {}};
        Tensor<1, dim> M;
        for (unsigned int i = 0; i < choice.size(); ++i)
          M += (duals[i] * target) * directions[i];
        if ((target - M).norm() >= least)
          continue;
        least  = (target - M).norm();
        result = {M, {}, duals};
        for (const unsigned int i : choice)
          result.side.push_back(cone[i]);
      }
    return result;
  }

#define INSTANTIATE(dim)                                           \
  template void find_corners(const FaceShape<dim> &,               \
                             const std::vector<MortarFace<dim>> &, \
                             std::vector<MortarNode<dim>> &);      \
  template void restrict_to_symmetry_planes(                       \
    const FaceShape<dim> &,                                        \
    const std::vector<MortarFace<dim>> &,                          \
    MortarNode<dim> &);                                            \
  template std::vector<Tensor<2, dim>> generator_derivative(       \
    const FaceShape<dim> &,                                        \
    const MortarNode<dim> &,                                       \
    const std::vector<MortarFace<dim>> &,                          \
    const ConeGenerator<dim> &);                                   \
  template std::vector<ConeGenerator<dim>> cone_of(                \
    const FaceShape<dim> &,                                        \
    const MortarNode<dim> &,                                       \
    const std::vector<MortarFace<dim>> &);                         \
  template NearestInCone<dim> nearest_in_cone(                     \
    const std::vector<ConeGenerator<dim>> &, const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
