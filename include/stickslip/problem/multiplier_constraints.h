#ifndef stickslip_problem_multiplier_constraints_h
#define stickslip_problem_multiplier_constraints_h

#include <stickslip/base/types.h>

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/boundary_conditions.h>

#include <vector>

namespace stickslip
{
  /**
   * Constraints of the multipliers: they follow the displacements where these
   * are interpolated (hanging and periodic nodes) and are zero at excluded
   * nodes and at nodes that cannot move against a master that cannot move.
   */
  template <int dim>
  class MultiplierConstraints
  {
  public:
    /// Keeps a reference to @p contact.
    MultiplierConstraints(const Bodies                  &bodies,
                          const BoundaryConditions<dim> &boundary_conditions,
                          const ContactAssembler<dim>   &contact);

    /// Adds them to the @p lines of an increment, which hold those of the
    /// displacements; the @p geometric ones need not be closed. Multipliers are
    /// numbered behind @p n_displacements displacements. Not collective.
    void
    add_to(Constraints                  &lines,
           const Constraints            &geometric,
           const types::global_dof_index n_displacements) const;

  private:
    const ContactAssembler<dim> &contact;
    std::vector<bool>            master_is_rigid; ///< by pair
  };
} // namespace stickslip

#endif
