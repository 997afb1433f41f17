#include <stickslip/contact/pairing/corner_normals.h>

#include <stickslip/contact/pairing/corner_cone.h>
#include <stickslip/contact/surface/projected_face.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace stickslip
{
  namespace
  {
    /// A cone that has less of the direction to the master does not face it.
    constexpr double least_part_in_cone = 0.1;

    /// A node whose projection is farther from the middle of the master face,
    /// in its coordinates, has nothing opposite.
    constexpr double farthest_extrapolation = 1.;



    /// The point of the master opposite a node: x_m(eta) + distance n_0 = x,
    /// with the direction n_0 along which a face around the node is projected.
    template <int dim>
    struct Opposite
    {
      bool           is_there = false;
      unsigned int   around   = 0; ///< number of the face around the node
      unsigned int   master   = 0; ///< number in the patch
      Point<dim - 1> eta;
      double         distance = 0.;

      Tensor<2, dim> inverse; ///< of the matrix of (a_alpha, n_0)
    };



    /// The segments' point that is nearest to the node on one of its faces.
    template <int dim>
    Opposite<dim>
    nearest_point(const FaceShape<dim>                 &shape,
                  const MortarNode<dim>                &node,
                  const std::vector<FaceSegments<dim>> &segments)
    {
      Opposite<dim> result;
      double        least = 1.;
      for (unsigned int a = 0; a < node.faces.size(); ++a)
        {
          const auto              &around  = node.faces[a];
          const Point<dim - 1>    &place   = shape.node(around.displacement);
          const FaceSegments<dim> &of_face = segments[around.face];
          for (const auto &point : of_face.points)
            if (point.xi.distance(place) < least)
              {
                least           = point.xi.distance(place);
                result.is_there = true;
                result.around   = a;
                result.master   = of_face.masters[point.master];
                result.eta      = point.eta;
              }
        }
      return result;
    }



    /// Where the node itself is projected to on the master face of the nearest
    /// point: it may lie a little beyond the face's end.
    template <int dim>
    Opposite<dim>
    opposite_of(const FaceShape<dim>                 &shape,
                const MortarNode<dim>                &node,
                const std::vector<MortarFace<dim>>   &faces,
                const std::vector<FaceSegments<dim>> &segments,
                const MasterPatch<dim>               &patch)
    {
      Opposite<dim> result = nearest_point(shape, node, segments);
      if (!result.is_there)
        return result;
      const auto            &around = node.faces[result.around];
      const MortarFace<dim> &slave  = faces[around.face];
      const Tensor<1, dim>   n_0 =
        projection_plane(slave.face, shape, slave.positions).n;
      const Tensor<1, dim> x     = slave.positions[around.displacement];
      const auto          &nodes = patch.configuration(result.master).positions;

      FaceShapeValues<dim> values;
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          shape.evaluate(result.eta, values);
          const auto     a = surface_tangents<dim>(values.gradient, nodes);
          Tensor<2, dim> jacobian;
          for (unsigned int i = 0; i < dim; ++i)
            {
              for (unsigned int d = 0; d < dim - 1; ++d)
                jacobian[i][d] = a[d][i];
              jacobian[i][dim - 1] = n_0[i];
            }
          result.inverse = invert(jacobian);
          const Tensor<1, dim> step =
            result.inverse * (x - interpolate<dim>(values.value, nodes));
          result.distance = step[dim - 1];
          double size     = 0.;
          for (unsigned int d = 0; d < dim - 1; ++d)
            {
              result.eta[d] += step[d];
              size = std::max(size, std::abs(step[d]));
            }
          if (size < 1e-14)
            break;
        }
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (!(std::abs(result.eta[d] - 0.5) < farthest_extrapolation))
          result.is_there = false;
      return result;
    }



    /// Change of a_1 x a_2 when eta_d grows.
    template <int dim>
    Tensor<1, dim>
    normal_along(const std::array<Tensor<1, dim>, dim - 1> &a,
                 const FaceShapeValues<dim>                &values,
                 const std::vector<Tensor<1, dim>>         &nodes,
                 const unsigned int                         d)
    {
      std::array<Tensor<1, dim>, dim - 1> D_a;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        for (unsigned int alpha = 0; alpha < dim - 1; ++alpha)
          D_a[alpha] += values.hessian[k][alpha][d] * nodes[k];
      if constexpr (dim == 2)
        return surface_normal<dim>(D_a);
      else
        return cross_product_3d(D_a[0], a[1]) + cross_product_3d(a[0], D_a[1]);
    }



    /// The nearest vector M of the cone to the master's normal t, turned round.
    template <int dim>
    struct CornerNormal
    {
      Opposite<dim>        opposite;
      FaceShapeValues<dim> values; ///< on the master
      Tensor<1, dim>       t;
      NearestInCone<dim>   nearest;
    };



    template <int dim>
    CornerNormal<dim>
    corner_normal(const FaceShape<dim>                 &shape,
                  const MortarNode<dim>                &node,
                  const std::vector<MortarFace<dim>>   &faces,
                  const std::vector<FaceSegments<dim>> &segments,
                  const MasterPatch<dim>               &patch)
    {
      CornerNormal<dim> result;
      result.opposite = opposite_of(shape, node, faces, segments, patch);
      if (!result.opposite.is_there)
        return result;
      const unsigned int m = result.opposite.master;
      shape.evaluate(result.opposite.eta, result.values);
      result.t =
        -1. *
        outward_normal(patch.face(m),
                       surface_tangents<dim>(result.values.gradient,
                                             patch.configuration(m).positions));
      result.t /= result.t.norm();
      result.nearest = nearest_in_cone(cone_of(shape, node, faces), result.t);
      return result;
    }



    /// Derivative of t, per [stencil node, then master node].
    template <int dim>
    std::vector<Tensor<2, dim>>
    master_normal_derivative(const FaceShape<dim>               &shape,
                             const MortarNode<dim>              &node,
                             const MortarAverage<dim>           &average,
                             const std::vector<MortarFace<dim>> &faces,
                             const MasterPatch<dim>             &patch,
                             const CornerNormal<dim>            &corner)
    {
      const auto             &opposite = corner.opposite;
      const auto             &around   = node.faces[opposite.around];
      const MortarFace<dim>  &slave    = faces[around.face];
      const SurfaceFace<dim> &master   = patch.face(opposite.master);
      const auto &nodes = patch.configuration(opposite.master).positions;
      const auto  a     = surface_tangents<dim>(corner.values.gradient, nodes);
      // t = orientation v / |v| with v = a_1 x a_2
      const Tensor<2, dim> D_unit =
        master.orientation * unit_vector_derivative(surface_normal<dim>(a));
      const auto                  D_n_0 = outward_normal_derivative(slave.face,
                                                   slave.positions,
                                                   shape.at_centre());
      std::vector<Tensor<2, dim>> D_t(node.n_stencil_nodes() +
                                      average.n_master_nodes());

      std::map<types::global_dof_index, unsigned int> numbers;
      for (unsigned int l = 0; l < average.n_master_nodes(); ++l)
        numbers[average.master_dofs[l * dim]] = node.n_stencil_nodes() + l;
      for (unsigned int k = 0; k < master.n_nodes; ++k)
        if (const auto number = numbers.find(master.dofs[k * dim]);
            number != numbers.end()) // else without a share in the integrals
          D_t[number->second] +=
            D_unit *
            surface_normal_derivative<dim>(a, corner.values.gradient[k]);

      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          // eta_d moves with the nodes of both faces
          const Tensor<1, dim> along =
            D_unit * normal_along(a, corner.values, nodes, d);
          const Tensor<1, dim> &row = opposite.inverse[d];
          for (unsigned int k = 0; k < master.n_nodes; ++k)
            if (const auto number = numbers.find(master.dofs[k * dim]);
                number != numbers.end())
              D_t[number->second] -=
                outer_product(along, corner.values.value[k] * row);
          for (unsigned int k = 0; k < around.stencil.size(); ++k)
            D_t[around.stencil[k]] +=
              outer_product(along,
                            (k == around.displacement ? 1. : 0.) * row -
                              opposite.distance * (row * D_n_0[k]));
        }
      return D_t;
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
                               std::vector<Tensor<2, dim>>          &D_normal)
  {
    const CornerNormal<dim> corner =
      corner_normal(shape, node, faces, segments, patch);
    const auto D_t =
      master_normal_derivative(shape, node, average, faces, patch, corner);

    // M = G a with G^T G a = G^T t, so that with P = G (G^T G)^-1 G^T
    // D M = P D t + (1 - P) D G a + G (G^T G)^-1 D G^T (t - M)
    const unsigned int   n = corner.nearest.side.size();
    Tensor<2, dim>       P = unit_symmetric_tensor<dim>();
    const Tensor<2, dim> identity(P);
    FullMatrix<double>   inverse(n, n);
    if (n > 0)
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            inverse(i, j) = corner.nearest.side[i].direction *
                            corner.nearest.side[j].direction;
        inverse.gauss_jordan();
        P = 0.;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            P +=
              inverse(i, j) * outer_product(corner.nearest.side[i].direction,
                                            corner.nearest.side[j].direction);
      }
    for (unsigned int k = 0; k < D_t.size(); ++k)
      D_normal[k] += P * D_t[k];
    for (unsigned int i = 0; i < n; ++i)
      {
        const ConeGenerator<dim> &generator = corner.nearest.side[i];
        Tensor<1, dim>            dual;
        for (unsigned int j = 0; j < n; ++j)
          dual += inverse(j, i) * corner.nearest.side[j].direction;
        const auto            &around = node.faces[generator.around];
        const MortarFace<dim> &slave  = faces[around.face];
        const auto             D_g =
          outward_normal_derivative(slave.face,
                                    slave.positions,
                                    shape.at_node(around.displacement));
        for (unsigned int k = 0; k < around.stencil.size(); ++k)
          D_normal[around.stencil[k]] +=
            corner.nearest.shares[i] * (identity - P) * D_g[k] +
            outer_product(dual, (corner.t - corner.nearest.M) * D_g[k]);
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
    std::vector<Tensor<2, dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
