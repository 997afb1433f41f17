#ifndef stickslip_solid_surface_loads_h
#define stickslip_solid_surface_loads_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/by_kind.h>

#include <stickslip/solid/cell_kernel.h>
#include <stickslip/solid/load.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/mapping_collection.h>

#include <map>
#include <vector>

namespace stickslip
{
  /**
   * Forces on boundary faces, with N the outward normal and dA the area in the
   * reference configuration and p > 0 for compression:
   *
   * - traction t (dead): external += t dA, also of distributed forces,
   * - pressure (dead): external += -p N dA,
   * - follower pressure: external += -p n da = -p cof(F) N dA, where cof(F)
   *   depends on the displacements along the face only (in 2D per undeformed
   *   thickness),
   * - spring: internal += k d (d . u) dA, or k u dA without a direction.
   */
  template <int dim>
  class SurfaceLoads
  {
  public:
    /// Keeps references to @p mapping and to the members of @p loads.
    SurfaceLoads(const hp::MappingCollection<dim> &mapping,
                 const DoFHandler<dim>            &dof_handler,
                 const std::vector<Load<dim>>     &loads);

    /// True if add_cell() has something to add.
    bool
    act_on(const typename DoFHandler<dim>::active_cell_iterator &cell) const;

    /// Adds forces (and stiffness) of all loaded faces of one cell.
    void
    add_cell(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const double                                          time,
             const bool                                            with_tangent,
             ElementArrays<dim>                                   &element);

  private:
    void
    add_load(const Load<dim>         &load,
             const FEFaceValues<dim> &fe_face_values,
             const double             time,
             const bool               with_tangent,
             ElementArrays<dim>      &element) const;

    void
    add_tangent(const Load<dim>         &load,
                const FEFaceValues<dim> &fe_face_values,
                const unsigned int       q,
                const Tensor<2, 3>      &F,
                const double             time,
                ElementArrays<dim>      &element) const;

    std::map<types::boundary_id, std::vector<const Load<dim> *>> loads_of;

    ByKind<FEFaceValues<dim>> values_of_faces;
  };

  /**
   * Force of @p load per reference area at a point X of a face with the outward
   * normal N, as an external force. Follower pressures need the deformation
   * gradient @p F, springs the displacement @p u, other loads neither.
   */
  template <int dim>
  Tensor<1, dim>
  surface_force(const Load<dim>      &load,
                const Point<dim>     &X,
                const Tensor<1, dim> &N,
                const Tensor<2, 3>   &F,
                const Tensor<1, dim> &u,
                const double          time);

  /**
   * Cofactor of F (dim x dim), cof(F) = det(F) F^{-T}, as a polynomial: also
   * defined where F is singular.
   */
  template <int dim>
  Tensor<2, dim>
  cofactor(const Tensor<2, dim> &F);

  template <>
  Tensor<2, 2>
  cofactor(const Tensor<2, 2> &F);

  template <>
  Tensor<2, 3>
  cofactor(const Tensor<2, 3> &F);

  /// d (cof(F) N)_i / dF_kL
  template <int dim>
  Tensor<3, dim>
  cofactor_derivative(const Tensor<2, dim> &F, const Tensor<1, dim> &N);

  template <>
  Tensor<3, 2>
  cofactor_derivative(const Tensor<2, 2> &F, const Tensor<1, 2> &N);

  template <>
  Tensor<3, 3>
  cofactor_derivative(const Tensor<2, 3> &F, const Tensor<1, 3> &N);
} // namespace stickslip

#endif
