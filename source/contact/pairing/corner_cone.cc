#include <stickslip/contact/pairing/corner_cone.h>

#include <algorithm>

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



    template <int dim>
    std::vector<Tensor<1, dim>>
    undeformed(const SurfaceFace<dim> &face)
    {
      return {face.reference_positions.begin(),
              face.reference_positions.begin() + face.n_nodes};
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
                node.is_corner = true;
          }
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
        cone.push_back({unit_normal_at(shape,
                                       slave.face,
                                       around.displacement,
                                       slave.positions),
                        a});
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
    const std::vector<MortarFace<dim>> &);                                                    \
  template NearestInCone<dim> nearest_in_cone(                                                \
    const std::vector<ConeGenerator<dim>> &, const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
