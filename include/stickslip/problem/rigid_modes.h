#ifndef stickslip_problem_rigid_modes_h
#define stickslip_problem_rigid_modes_h

#include <stickslip/base/block_system.h>

#include <stickslip/mesh/body.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

namespace stickslip
{
  /// Of the nodes of @p dof_handler (FE_Q^dim, all components of a node one
  /// after the other).
  template <int dim>
  NodePlaces
  node_places(const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler,
              const Bodies                     &bodies);



  /**
   * Nodal vectors of @p dof_handler (FE_Q^dim): the rigid motions (3 in 2D, 6
   * in 3D; rotations about the centre of the model and scaled with its size).
   * Zero where @p constraints constrain, which is all of a rigid body but the
   * displacements that stand for its motion. Collective.
   */
  template <int dim>
  NearNullSpace
  rigid_modes(const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler,
              const Constraints                &constraints,
              const Bodies                     &bodies);
} // namespace stickslip

#endif
