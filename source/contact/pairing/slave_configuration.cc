#include <stickslip/contact/pairing/slave_configuration.h>

#include <stickslip/contact/pairing/master_patch.h>

namespace stickslip
{
  template <int dim>
  void
  SlaveConfiguration<dim>::update(const std::vector<SlaveFace<dim>> &faces,
                                  const LA::Vector                  &u,
                                  const LA::Vector                  &u_old)
  {
    now.resize(faces.size());
    old.resize(faces.size());
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        const SurfaceFace<dim> &face = faces[f].face;
        read_positions(face, face.n_nodes, u, now[f]);
        read_positions(face, face.n_nodes, u_old, old[f]);
      }
  }



  template <int dim>
  SlavePosition<dim>
  SlaveConfiguration<dim>::position(const SlaveShapeTable<dim> &table,
                                    const ContactPoint<dim>    &point) const
  {
    SlavePosition<dim> slave;
    const unsigned int f = point.geometry.slave_face;
    const auto        &value =
      table.displacement[point.geometry.quadrature_index].value;
    for (unsigned int j = 0; j < now[f].size(); ++j)
      {
        slave.x += value[j] * now[f][j];
        slave.x_old += value[j] * old[f][j];
        slave.direction += point.geometry.direction_gradients[j] * now[f][j];
      }
    slave.gap_offset = point.gap_offset;
    return slave;
  }



  template <int dim>
  Tensor<1, dim>
  SlaveConfiguration<dim>::normal(const std::vector<SlaveFace<dim>> &faces,
                                  const SlaveShapeTable<dim>        &table,
                                  const ContactPoint<dim> &point) const
  {
    const unsigned int   f = point.geometry.slave_face;
    const Tensor<1, dim> v =
      -faces[f].face.orientation *
      surface_normal<dim>(surface_tangents<dim>(
        table.displacement[point.geometry.quadrature_index].gradient, now[f]));
    return v / v.norm();
  }



  template <int dim>
  double
  SlaveConfiguration<dim>::area_ratio(const std::vector<SlaveFace<dim>> &faces,
                                      const SlaveShapeTable<dim>        &table,
                                      const ContactPoint<dim>           &point,
                                      const CrossSection &section) const
  {
    const unsigned int f         = point.geometry.slave_face;
    const auto        &reference = faces[f].face.reference_positions;
    const std::vector<Tensor<1, dim>> undeformed(reference.begin(),
                                                 reference.end());
    const auto                       &gradient =
      table.displacement[point.geometry.quadrature_index].gradient;
    const auto   a = surface_tangents<dim>(gradient, now[f]);
    const auto   A = surface_tangents<dim>(gradient, undeformed);
    const double in_section =
      surface_normal<dim>(a).norm() / surface_normal<dim>(A).norm();
    if (!section.is_axisymmetric)
      return in_section;
    // on the axis the ratio of the radii is that of what they grow by
    const double radius = point.geometry.reference_position[0];
    if (radius > section.radius_of_axis)
      return in_section * position(table, point).x[0] / radius;
    return A[0][0] != 0. ? in_section * a[0][0] / A[0][0] : in_section;
  }

  template class SlaveConfiguration<2>;
  template class SlaveConfiguration<3>;
} // namespace stickslip
