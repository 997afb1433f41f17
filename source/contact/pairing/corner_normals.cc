#include <stickslip/contact/pairing/corner_normals.h>

#include <stickslip/contact/pairing/corner_cone.h>
#include <stickslip/contact/pairing/partner_motion.h>
#include <stickslip/contact/pairing/surface_borders.h>

#include <array>
#include <map>

namespace stickslip
{
  namespace
  {
    /// A cone that has less of the direction to the master does not face it.
    constexpr double least_part_in_cone = 0.1;



    /// How much a place on a face counts for one of its nodes: 1 there, none at
    /// the sides opposite. Of the lowest degree, so that the segments' points
    /// are exact for the integrals with it.
    template <int dim>
    class Nearness
    {
    public:
      Nearness(const FaceShape<dim> &shape, const unsigned int j)
        : shape(shape)
        , sides(sides_of_node(shape, j))
      {}

      double
      operator()(const Point<dim - 1> &xi) const
      {
        const auto distances = distances_to_sides(shape, xi);
        double     result    = 1.;
        for (const unsigned int side : sides)
          result *= 1. - distances[side];
        return result;
      }

    private:
      const FaceShape<dim>           &shape;
      const std::vector<unsigned int> sides;
    };



    /// What is opposite a face around a node, seen as one plane.
    template <int dim>
    struct Opposite
    {
      Point<dim - 1> mean_xi; ///< weighted with the nearness
      Tensor<1, dim> mean_x;  ///< likewise, on the master
      /// Tangents: integrals of (xi_d - mean_xi_d) (x_m - mean_x).
      std::array<Tensor<1, dim>, dim - 1> S;
    };



    template <int dim>
    Opposite<dim>
    look_opposite(const FaceShape<dim>    &shape,
                  const unsigned int       j,
                  const FaceSegments<dim> &segments,
                  const MasterPatch<dim>  &patch)
    {
      Opposite<dim>               opposite;
      std::vector<double>         weights, N;
      std::vector<Tensor<1, dim>> x_m;
      double                      sum = 0.;
      const Nearness<dim>         nearness(shape, j);
      for (const auto &point : segments.points)
        {
          weights.push_back(point.weight * nearness(point.xi));
          patch.face_shape().evaluate_values(point.eta, N);
          x_m.push_back(interpolate<dim>(
            N, patch.configuration(segments.masters[point.master]).positions));
          sum += weights.back();
          opposite.mean_xi += weights.back() * point.xi;
          opposite.mean_x += weights.back() * x_m.back();
        }
      if (!(sum > 0.))
        return opposite;
      opposite.mean_xi /= sum;
      opposite.mean_x /= sum;
      for (unsigned int q = 0; q < weights.size(); ++q)
        for (unsigned int d = 0; d < dim - 1; ++d)
          opposite.S[d] += weights[q] *
                           (segments.points[q].xi[d] - opposite.mean_xi[d]) *
                           (x_m[q] - opposite.mean_x);
      return opposite;
    }



    /// Columns: [stencil node, then master node of the average] * dim.
    template <int dim>
    using TangentDerivatives =
      std::array<std::vector<Tensor<1, dim>>, dim - 1>; ///< [d][column]



    template <int dim>
    class OppositeDerivative
    {
    public:
      OppositeDerivative(const FaceShape<dim>     &shape,
                         const MortarNode<dim>    &node,
                         const MortarAverage<dim> &average,
                         const MasterPatch<dim>   &patch,
                         const bool                partners_move)
        : shape(shape)
        , patch(patch)
        , n_columns((node.n_stencil_nodes() + average.n_master_nodes()) * dim)
        , partners_move(partners_move)
      {
        for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
          columns_of_nodes[average.masters.name(l)] =
            node.n_stencil_nodes() + l;
      }

      /// Of the tangents S of what is opposite a face around the node.
      TangentDerivatives<dim>
      of_tangents(const typename MortarNode<dim>::Around &around,
                  const MortarFace<dim>                  &slave,
                  const FaceSegments<dim>                &segments,
                  const Opposite<dim>                    &opposite) const
      {
        const Nearness<dim>      nearness(shape, around.displacement);
        const PartnerMotion<dim> motion(shape, patch.face_shape(), slave);
        TangentDerivatives<dim>  D_S;
        D_S.fill(std::vector<Tensor<1, dim>>(n_columns));
        typename PartnerMotion<dim>::Partner partner;
        std::vector<double>                  D_eta;
        std::vector<unsigned int>            columns;
        unsigned int                         m = numbers::invalid_unsigned_int;
        for (const auto &point : segments.points)
          {
            if (m != segments.masters[point.master])
              {
                m       = segments.masters[point.master];
                columns = columns_of(around, m);
              }
            motion.evaluate(point, patch.configuration(m).positions, partner);
            const auto weights =
              weights_at(point.xi, nearness, opposite, point.weight);
            for (unsigned int d = 0; d < dim - 1; ++d)
              for (unsigned int k = 0; k < partner.master.value.size(); ++k)
                for (unsigned int c = 0; c < dim; ++c)
                  D_S[d][columns[(shape.n_nodes() + k) * dim + c]][c] +=
                    weights[d] * partner.master.value[k];
            if (!partners_move)
              continue;
            for (unsigned int e = 0; e < dim - 1; ++e)
              {
                motion.partner_derivative(partner, e, D_eta);
                for (unsigned int d = 0; d < dim - 1; ++d)
                  for (unsigned int k = 0; k < columns.size(); ++k)
                    D_S[d][columns[k]] +=
                      (weights[d] * D_eta[k]) * partner.a[e];
              }
          }
        if (partners_move)
          add_ends(around, motion, segments, nearness, opposite, D_S);
        return D_S;
      }

    private:
      const FaceShape<dim>            &shape;
      const MasterPatch<dim>          &patch;
      const unsigned int               n_columns;
      const bool                       partners_move;
      std::map<NodeName, unsigned int> columns_of_nodes;

      /// Columns of the nodes of a slave face and of a master face.
      std::vector<unsigned int>
      columns_of(const typename MortarNode<dim>::Around &around,
                 const unsigned int                      master) const
      {
        const SurfaceFace<dim>   &face = patch.face(master);
        std::vector<unsigned int> master_nodes;
        for (unsigned int k = 0; k < face.n_nodes; ++k)
          master_nodes.push_back(columns_of_nodes.at(face.name(k)));
        return around.columns(0, master_nodes);
      }

      Tensor<1, dim - 1>
      weights_at(const Point<dim - 1> &xi,
                 const Nearness<dim>  &nearness,
                 const Opposite<dim>  &opposite,
                 const double          area) const
      {
        return (area * nearness(xi)) * (xi - opposite.mean_xi);
      }

      /// What the motion of the borders changes where the master ends.
      void
      add_ends(const typename MortarNode<dim>::Around &around,
               const PartnerMotion<dim>               &motion,
               const FaceSegments<dim>                &segments,
               const Nearness<dim>                    &nearness,
               const Opposite<dim>                    &opposite,
               TangentDerivatives<dim>                &D_S) const
      {
        std::vector<double>       N_master, gain;
        std::vector<unsigned int> columns;
        unsigned int              m = numbers::invalid_unsigned_int;
        for (const auto &end : segments.ends)
          {
            if (m != segments.masters[end.master])
              {
                m       = segments.masters[end.master];
                columns = columns_of(around, m);
              }
            const auto &positions = patch.configuration(m).positions;
            motion.border_motion(end, positions, gain);
            patch.face_shape().evaluate_values(end.eta, N_master);
            const Tensor<1, dim> x =
              interpolate<dim>(N_master, positions) - opposite.mean_x;
            const auto weights = weights_at(end.xi, nearness, opposite, 1.);
            for (unsigned int d = 0; d < dim - 1; ++d)
              for (unsigned int k = 0; k < columns.size(); ++k)
                D_S[d][columns[k]] += (weights[d] * gain[k]) * x;
          }
      }
    };



    /// Change of surface_normal() of the tangents @p S along one column.
    template <int dim>
    Tensor<1, dim>
    normal_change(const std::array<Tensor<1, dim>, dim - 1> &S,
                  const TangentDerivatives<dim>             &D_S,
                  const unsigned int                         column)
    {
      if constexpr (dim == 2)
        return surface_normal<dim>({{D_S[0][column]}});
      else
        return cross_product_3d(D_S[0][column], S[1]) +
               cross_product_3d(S[0], D_S[1][column]);
    }



    /// The nearest vector of the cone to the master's normal, turned round.
    template <int dim>
    struct CornerNormal
    {
      std::vector<Opposite<dim>> opposites; ///< per face around the node
      Tensor<1, dim>             v; ///< sum of the normals of what is opposite,
                                    ///< in the symmetry planes
      NearestInCone<dim> nearest;   ///< to v / |v|
    };



    template <int dim>
    CornerNormal<dim>
    corner_normal(const FaceShape<dim>                 &shape,
                  const MortarNode<dim>                &node,
                  const std::vector<MortarFace<dim>>   &faces,
                  const std::vector<FaceSegments<dim>> &segments,
                  const MasterPatch<dim>               &patch)
    {
      CornerNormal<dim> corner;
      for (const auto &around : node.faces)
        {
          corner.opposites.push_back(look_opposite(
            shape, around.displacement, segments[around.face], patch));
          corner.v +=
            outward_normal(faces[around.face].face, corner.opposites.back().S);
        }
      corner.v = node.projection * corner.v;
      if (corner.v.norm() > 0.)
        corner.nearest = nearest_in_cone(cone_of(shape, node, faces),
                                         corner.v / corner.v.norm());
      return corner;
    }
  } // namespace



  template <int dim>
  bool
  find_corner_normal(const FaceShape<dim>                 &shape,
                     const MortarNode<dim>                &node,
                     const std::vector<MortarFace<dim>>   &faces,
                     const std::vector<FaceSegments<dim>> &segments,
                     const MasterPatch<dim>               &patch,
                     MortarFrame<dim>                     &frame)
  {
    const CornerNormal<dim> corner =
      corner_normal(shape, node, faces, segments, patch);
    if (corner.nearest.M.norm() < least_part_in_cone)
      return false;
    frame.length       = corner.nearest.M.norm();
    frame.n            = corner.nearest.M / frame.length;
    frame.is_of_corner = true;
    return true;
  }



  template <int dim>
  void
  add_corner_normal_derivative(const FaceShape<dim>                 &shape,
                               const MortarNode<dim>                &node,
                               const MortarAverage<dim>             &average,
                               const std::vector<MortarFace<dim>>   &faces,
                               const std::vector<FaceSegments<dim>> &segments,
                               const MasterPatch<dim>               &patch,
                               const bool                   partners_move,
                               std::vector<Tensor<2, dim>> &D_normal)
  {
    const CornerNormal<dim> corner =
      corner_normal(shape, node, faces, segments, patch);

    // M = G a with G^T G a = G^T t, so that with P = G (G^T G)^-1 G^T
    // D M = P D t + (1 - P) D G a + G (G^T G)^-1 D G^T (t - M)
    const auto          &side  = corner.nearest.side;
    const auto          &duals = corner.nearest.duals; // G (G^T G)^-1
    const Tensor<2, dim> identity(unit_symmetric_tensor<dim>());
    Tensor<2, dim>       P;
    for (unsigned int i = 0; i < side.size(); ++i)
      P += outer_product(duals[i], side[i].direction);
    if (side.empty())
      P = identity;

    const Tensor<2, dim> D_t =
      P * unit_vector_derivative(corner.v) * node.projection;
    const OppositeDerivative<dim> derivative(
      shape, node, average, patch, partners_move);
    for (unsigned int f = 0; f < node.faces.size(); ++f)
      {
        const auto            &around   = node.faces[f];
        const MortarFace<dim> &slave    = faces[around.face];
        const Opposite<dim>   &opposite = corner.opposites[f];
        if (segments[around.face].points.empty())
          continue;
        const auto D_S = derivative.of_tangents(around,
                                                slave,
                                                segments[around.face],
                                                opposite);
        for (unsigned int k = 0; k < D_normal.size(); ++k)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const Tensor<1, dim> change =
                D_t * (-slave.face.orientation *
                       normal_change<dim>(opposite.S, D_S, k * dim + c));
              for (unsigned int i = 0; i < dim; ++i)
                D_normal[k][i][c] += change[i];
            }
      }

    const Tensor<1, dim> t = corner.v / corner.v.norm();
    for (unsigned int i = 0; i < side.size(); ++i)
      {
        const auto &around = node.faces[side[i].around];
        const auto  D_g    = generator_derivative(shape, node, faces, side[i]);
        for (unsigned int k = 0; k < around.stencil.size(); ++k)
          D_normal[around.stencil[k]] +=
            (duals[i] * t) * (identity - P) * D_g[k] +
            outer_product(duals[i], (t - corner.nearest.M) * D_g[k]);
      }
  }

#define INSTANTIATE(dim)                                                   \
  template bool find_corner_normal(const FaceShape<dim> &,                 \
                                   const MortarNode<dim> &,                \
                                   const std::vector<MortarFace<dim>> &,   \
                                   const std::vector<FaceSegments<dim>> &, \
                                   const MasterPatch<dim> &,               \
                                   MortarFrame<dim> &);                    \
  template void add_corner_normal_derivative(                              \
    const FaceShape<dim> &,                                                \
    const MortarNode<dim> &,                                               \
    const MortarAverage<dim> &,                                            \
    const std::vector<MortarFace<dim>> &,                                  \
    const std::vector<FaceSegments<dim>> &,                                \
    const MasterPatch<dim> &,                                              \
    const bool,                                                            \
    std::vector<Tensor<2, dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
