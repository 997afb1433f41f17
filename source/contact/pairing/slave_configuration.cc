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
  area_ratio(const FaceShapeValues<dim>        &values,
             const SurfaceFace<dim>            &face,
             const std::vector<Tensor<1, dim>> &now,
             const CrossSection                &section)
  {
    const auto   undeformed = face.undeformed_nodes();
    const auto   a          = surface_tangents<dim>(values.gradient, now);
    const auto   A = surface_tangents<dim>(values.gradient, undeformed);
    const double in_section =
      surface_normal<dim>(a).norm() / surface_normal<dim>(A).norm();
    if (!section.is_axisymmetric)
      return in_section;
    // on the axis the ratio of the radii is that of what they grow by
    const double radius = interpolate<dim>(values.value, undeformed)[0];
    if (radius > section.radius_of_axis)
      return in_section * interpolate<dim>(values.value, now)[0] / radius;
    return A[0][0] != 0. ? in_section * a[0][0] / A[0][0] : in_section;
  }

  template double
  area_ratio(const FaceShapeValues<2> &,
             const SurfaceFace<2> &,
             const std::vector<Tensor<1, 2>> &,
             const CrossSection &);
  template double
  area_ratio(const FaceShapeValues<3> &,
             const SurfaceFace<3> &,
             const std::vector<Tensor<1, 3>> &,
             const CrossSection &);
  template class SlaveConfiguration<2>;
  template class SlaveConfiguration<3>;
} // namespace stickslip
