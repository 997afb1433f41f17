#ifndef stickslip_problem_rigid_modes_h
#define stickslip_problem_rigid_modes_h

#include <stickslip/base/block_system.h>

#include <stickslip/contact/pairing/contact_pair.h>

#include <stickslip/mesh/body.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * A colour for each body, different for deformable bodies that touch: bodies
   * of one colour can share the vectors of a near null space, because no row
   * of a matrix sees both. The smallest colour is 0. Rigid bodies have none
   * (numbers::invalid_unsigned_int) unless they are @p driven, which is by body
   * (empty: none): the displacements that stand for their motion are unknowns.
   */
  template <int dim>
  std::vector<unsigned int>
  colour_bodies(const Bodies                                         &bodies,
                const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs,
                const std::vector<bool> &driven = {});

  /**
   * Nodal vectors of @p dof_handler (FE_Q^dim): the rigid motions of all
   * bodies together (3 in 2D, 6 in 3D; rotations about the centre of the model
   * and scaled with its size), then for each colour above 0 those of its bodies
   * alone. An aggregate of multigrid inside a body has no use for the second
   * ones and drops them; where it takes nodes of two bodies, they let these
   * slide, open and turn. Zero where
   * @p constraints constrain and on rigid bodies. Collective.
   */
  template <int dim>
  NearNullSpace
  rigid_modes(const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler,
              const Constraints                &constraints,
              const Bodies                     &bodies,
              const std::vector<unsigned int>  &colours);
} // namespace stickslip

#endif
