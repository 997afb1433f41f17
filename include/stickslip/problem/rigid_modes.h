#ifndef stickslip_problem_rigid_modes_h
#define stickslip_problem_rigid_modes_h

#include <stickslip/base/block_system.h>

#include <stickslip/contact/contact_pair.h>

#include <stickslip/mesh/body.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/mapping.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * A colour for each body, different for deformable bodies that touch: bodies
   * of one colour can share the vectors of a near null space, because no row
   * of a matrix sees both. Rigid bodies have none
   * (numbers::invalid_unsigned_int).
   */
  template <int dim>
  std::vector<unsigned int>
  colour_bodies(const Bodies                                         &bodies,
                const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs);

  /**
   * The rigid motions of the bodies, 3 in 2D and 6 in 3D for each colour, as
   * nodal vectors of @p dof_handler (FE_Q^dim). Zero on bodies of other colours
   * and where @p constraints constrain. Rotations are about the centre of a
   * body and scaled with its size. Collective.
   */
  template <int dim>
  NearNullSpace
  rigid_modes(const Mapping<dim>              &mapping,
              const DoFHandler<dim>           &dof_handler,
              const Constraints               &constraints,
              const Bodies                    &bodies,
              const std::vector<unsigned int> &colours);
} // namespace stickslip

#endif
