#ifndef stickslip_contact_pairing_slave_configuration_h
#define stickslip_contact_pairing_slave_configuration_h

#include <stickslip/contact/point/contact_points.h>

#include <vector>

namespace stickslip
{
  /// Current over reference area of a body at the place of @p values on one of
  /// its faces, whose nodes are @p now, and where the mesh has them.
  template <int dim>
  double
  area_ratio(const FaceShapeValues<dim>        &values,
             const SurfaceFace<dim>            &face,
             const std::vector<Tensor<1, dim>> &now,
             const CrossSection                &section);

  /// Where the owned slave faces of a pair, and the points on them, are: now
  /// and at the start of the step.
  template <int dim>
  class SlaveConfiguration
  {
  public:
    /// From ghosted displacements.
    void
    update(const std::vector<SlaveFace<dim>> &faces,
           const LA::Vector                  &u,
           const LA::Vector                  &u_old);

    /// Of the nodes of a face, now.
    const std::vector<Tensor<1, dim>> &
    positions(const unsigned int face) const
    {
      return now[face];
    }

    SlavePosition<dim>
    position(const SlaveShapeTable<dim> &table,
             const ContactPoint<dim>    &point) const;

    /// Outward unit normal of the face of a point.
    Tensor<1, dim>
    normal(const std::vector<SlaveFace<dim>> &faces,
           const SlaveShapeTable<dim>        &table,
           const ContactPoint<dim>           &point) const;

    /// Current over reference area of the body at a point.
    double
    area_ratio(const std::vector<SlaveFace<dim>> &faces,
               const SlaveShapeTable<dim>        &table,
               const ContactPoint<dim>           &point,
               const CrossSection                &section) const
    {
      return stickslip::area_ratio(
        table.displacement[point.geometry.quadrature_index],
        faces[point.geometry.slave_face].face,
        now[point.geometry.slave_face],
        section);
    }

  private:
    std::vector<std::vector<Tensor<1, dim>>> now; ///< [face][node]
    std::vector<std::vector<Tensor<1, dim>>> old;
  };
} // namespace stickslip

#endif
