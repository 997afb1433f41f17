#ifndef stickslip_contact_point_contact_points_h
#define stickslip_contact_point_contact_points_h

#include <stickslip/contact/point/contact_point.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/base/quadrature.h>

#include <set>
#include <vector>

namespace stickslip
{
  /// Shape functions of a slave face at the contact points, the same for all.
  template <int dim>
  struct SlaveShapeTable
  {
    SlaveShapeTable() = default;

    SlaveShapeTable(const FaceShape<dim>      &displacement_shape,
                    const FaceShape<dim>      &multiplier_shape,
                    const Quadrature<dim - 1> &quadrature);

    std::vector<FaceShapeValues<dim>> displacement; ///< [q]
    std::vector<std::vector<double>>  multiplier;   ///< [q][node]
  };

  /// Displacement node of a face at which multiplier node @p l sits.
  template <int dim>
  unsigned int
  displacement_node(const FaceShape<dim> &displacement_shape,
                    const FaceShape<dim> &multiplier_shape,
                    const unsigned int    l);

  /**
   * The contact points of the owned slave faces with their weights and
   * reference frames. Points whose multiplier shape functions all belong to
   * @p excluded nodes are left out. The averaged normals that carry the nodal
   * frames come from @p faces_with_ghosts, so they are the same on all ranks.
   * In a section of bodies of revolution the weights are areas all around;
   * those of two points are the integrals of the linear functions of these, so
   * that a point on the axis has one. Not collective.
   */
  template <int dim>
  std::vector<ContactPoint<dim>>
  make_contact_points(const Quadrature<dim - 1>             &quadrature,
                      const FaceShape<dim>                  &displacement_shape,
                      const FaceShape<dim>                  &multiplier_shape,
                      const SlaveShapeTable<dim>            &table,
                      const std::vector<SlaveFace<dim>>     &slave_faces,
                      const std::vector<CollectedFace<dim>> &faces_with_ghosts,
                      const std::set<types::global_dof_index> &excluded,
                      const CrossSection &cross_section = {});
} // namespace stickslip

#endif
