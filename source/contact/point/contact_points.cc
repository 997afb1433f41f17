#include <stickslip/contact/point/contact_points.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <map>

namespace stickslip
{
  namespace
  {
    /// Turns @p v, orthogonal to the unit vector a, so that it is orthogonal to
    /// the unit vector b, by the smallest rotation.
    template <int dim>
    Tensor<1, dim>
    turn(const Tensor<1, dim> &v,
         const Tensor<1, dim> &a,
         const Tensor<1, dim> &b)
    {
      return v - (b * v) / (1. + a * b) * (a + b);
    }



    /// A tangent of the plane normal to n, chosen by a rule that does not
    /// depend on facets or ranks.
    Tensor<1, 3>
    reference_tangent(const Tensor<1, 3> &n)
    {
      Tensor<1, 3> axis;
      axis[std::abs(n[0]) < 0.6 ? 0 : 1] = 1.;
      const Tensor<1, 3> t               = axis - (axis * n) * n;
      return t / t.norm();
    }



    /// Averaged reference normals of the slave nodes: they carry the frames of
    /// the nodal Lambda, so all ranks must agree on them.
    template <int dim>
    std::map<NodeName, Tensor<1, dim>>
    average_reference_normals(const std::vector<CollectedFace<dim>> &faces,
                              const FaceShape<dim> &displacement_shape)
    {
      std::map<NodeName, Tensor<1, dim>> nodal_normals;
      for (const auto &entry : faces)
        for (unsigned int j = 0; j < entry.face.n_nodes; ++j)
          {
            const std::vector<Tensor<1, dim>> nodes =
              entry.face.undeformed_nodes();
            const auto a =
              surface_tangents<dim>(displacement_shape.at_node(j).gradient,
                                    nodes);
            const Tensor<1, dim> v =
              -entry.face.orientation * surface_normal<dim>(a);
            nodal_normals[entry.face.name(j)] += v / v.norm();
          }
      for (auto &[key, normal] : nodal_normals)
        normal /= normal.norm();
      return nodal_normals;
    }



    /// The undeformed areas that the points of a face stand for.
    template <int dim>
    std::vector<double>
    areas_of_points(const Quadrature<dim - 1>               &quadrature,
                    const std::vector<FaceShapeValues<dim>> &table,
                    const FaceShape<dim>                    &shape,
                    const std::vector<Tensor<1, dim>>       &nodes,
                    const CrossSection                      &cross_section)
    {
      const auto area_at = [&](const FaceShapeValues<dim> &values) {
        return surface_normal<dim>(
                 surface_tangents<dim>(values.gradient, nodes))
                 .norm() *
               cross_section.circumference(
                 interpolate<dim>(values.value, nodes));
      };
      std::vector<double> areas;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        areas.push_back(quadrature.weight(q) * area_at(table[q]));
      if (!cross_section.is_axisymmetric || quadrature.size() != 2)
        return areas;

      const double         begin  = quadrature.point(0)[0];
      const double         length = quadrature.point(1)[0] - begin;
      const auto           exact  = QGauss<dim - 1>(shape.degree() + 2);
      FaceShapeValues<dim> values;
      areas.assign(2, 0.);
      for (unsigned int g = 0; g < exact.size(); ++g)
        {
          shape.evaluate(exact.point(g), values);
          const double area  = exact.weight(g) * area_at(values);
          const double share = (exact.point(g)[0] - begin) / length;
          areas[0] += (1. - share) * area;
          areas[1] += share * area;
        }
      return areas;
    }



    template <int dim>
    void
    set_reference_frames(
      ContactPoint<dim>                        &point,
      const SurfaceFace<dim>                   &face,
      const FaceShape<dim>                     &displacement_shape,
      const FaceShape<dim>                     &multiplier_shape,
      const std::vector<Tensor<1, dim - 1>>    &gradient,
      const std::map<NodeName, Tensor<1, dim>> &nodal_normals)
    {
      const unsigned int n_multipliers = multiplier_shape.n_nodes();
      point.geometry.direction_gradients.assign(face.n_nodes, 0.);
      Tensor<2, dim - 1> identity;
      for (unsigned int d = 0; d < dim - 1; ++d)
        identity[d][d] = 1.;
      point.geometry.reference_rotations.assign(n_multipliers, identity);
      if constexpr (dim == 3)
        {
          std::vector<Tensor<1, dim>> nodes;
          for (unsigned int j = 0; j < face.n_nodes; ++j)
            nodes.emplace_back(face.reference_positions[j]);
          const auto   A = surface_tangents<dim>(gradient, nodes);
          Tensor<1, 3> N = -face.orientation * surface_normal<dim>(A);
          N /= N.norm();
          const Tensor<1, 3> e_1 = reference_tangent(N);
          const Tensor<1, 3> e_2 = cross_product_3d(N, e_1);

          point.geometry.direction_gradients =
            direction_weights(gradient, A, e_1);

          for (unsigned int l = 0; l < n_multipliers; ++l)
            {
              const unsigned int j =
                displacement_node(displacement_shape, multiplier_shape, l);
              const Tensor<1, 3> N_l = nodal_normals.at(face.name(j));
              // of images: as at the node itself
              const Tensor<2, 3> R   = face.rotation(j);
              const Tensor<1, 3> T_1 = R * reference_tangent(N_l * R);
              const Tensor<1, 3> T_2 = cross_product_3d(N_l, T_1);
              const Tensor<1, 3> t_1 = turn(T_1, N_l, N);
              const Tensor<1, 3> t_2 = turn(T_2, N_l, N);
              point.geometry.reference_rotations[l][0][0] = e_1 * t_1;
              point.geometry.reference_rotations[l][0][1] = e_1 * t_2;
              point.geometry.reference_rotations[l][1][0] = e_2 * t_1;
              point.geometry.reference_rotations[l][1][1] = e_2 * t_2;
            }
        }
      else
        {
          (void)displacement_shape;
          (void)gradient;
          (void)nodal_normals;
        }
    }
  } // namespace



  template <int dim>
  SlaveShapeTable<dim>::SlaveShapeTable(
    const FaceShape<dim>      &displacement_shape,
    const FaceShape<dim>      &multiplier_shape,
    const Quadrature<dim - 1> &quadrature)
    : displacement(quadrature.size())
    , multiplier(quadrature.size())
  {
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        displacement_shape.evaluate(quadrature.point(q), displacement[q]);
        multiplier_shape.evaluate_values(quadrature.point(q), multiplier[q]);
      }
  }



  template <int dim>
  unsigned int
  displacement_node(const FaceShape<dim> &displacement_shape,
                    const FaceShape<dim> &multiplier_shape,
                    const unsigned int    l)
  {
    if (displacement_shape.is_triangle())
      return l; // vertices come first
    const unsigned int n      = displacement_shape.degree() + 1;
    const unsigned int m      = multiplier_shape.degree() + 1;
    const unsigned int stride = (n - 1) / (m - 1);
    return (l % m) * stride + (l / m) * stride * n;
  }



  template <int dim>
  std::vector<ContactPoint<dim>>
  make_contact_points(const Quadrature<dim - 1>             &quadrature,
                      const FaceShape<dim>                  &displacement_shape,
                      const FaceShape<dim>                  &multiplier_shape,
                      const SlaveShapeTable<dim>            &table,
                      const std::vector<SlaveFace<dim>>     &slave_faces,
                      const std::vector<CollectedFace<dim>> &faces_with_ghosts,
                      const std::set<types::global_dof_index> &excluded,
                      const CrossSection                      &cross_section)
  {
    const auto nodal_normals =
      average_reference_normals(faces_with_ghosts, displacement_shape);
    std::vector<ContactPoint<dim>> points;
    for (unsigned int f = 0; f < slave_faces.size(); ++f)
      {
        const auto nodes = slave_faces[f].face.undeformed_nodes();
        const auto areas = areas_of_points(quadrature,
                                           table.displacement,
                                           displacement_shape,
                                           nodes,
                                           cross_section);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            bool carries_multiplier = false;
            for (unsigned int l = 0; l < multiplier_shape.n_nodes(); ++l)
              carries_multiplier =
                carries_multiplier ||
                (std::abs(table.multiplier[q][l]) > 1e-12 &&
                 excluded.count(
                   slave_faces[f]
                     .face.dofs[dim * displacement_node(displacement_shape,
                                                        multiplier_shape,
                                                        l)]) == 0);
            if (!carries_multiplier)
              continue;
            ContactPoint<dim> point;
            point.geometry.slave_face       = f;
            point.geometry.quadrature_index = q;
            const auto &shape               = table.displacement[q];
            point.geometry.reference_position =
              interpolate<dim>(shape.value, nodes);
            point.geometry.weight = areas[q];
            set_reference_frames(point,
                                 slave_faces[f].face,
                                 displacement_shape,
                                 multiplier_shape,
                                 shape.gradient,
                                 nodal_normals);
            point.nodal_rotations = point.geometry.reference_rotations;
            points.push_back(point);
          }
      }
    return points;
  }

#define INSTANTIATE(dim)                                          \
  template struct SlaveShapeTable<dim>;                           \
  template unsigned int displacement_node(const FaceShape<dim> &, \
                                          const FaceShape<dim> &, \
                                          const unsigned int);    \
  template std::vector<ContactPoint<dim>> make_contact_points(    \
    const Quadrature<dim - 1> &,                                  \
    const FaceShape<dim> &,                                       \
    const FaceShape<dim> &,                                       \
    const SlaveShapeTable<dim> &,                                 \
    const std::vector<SlaveFace<dim>> &,                          \
    const std::vector<CollectedFace<dim>> &,                      \
    const std::set<types::global_dof_index> &,                    \
    const CrossSection &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
