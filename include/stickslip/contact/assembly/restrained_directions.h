#ifndef stickslip_contact_assembly_restrained_directions_h
#define stickslip_contact_assembly_restrained_directions_h

#include <stickslip/contact/assembly/contact_assembler.h>

namespace stickslip
{
  /**
   * Finds the directions along which constraints leave a contact point no
   * relative motion, and prescribe none in this step: a symmetry plane that
   * cuts both surfaces, u_z = 0 everywhere. No unknown could make such a point
   * slip, so nothing determines its Lambda there; on a tilted facet the row
   * would repeat that of lambda_n, and the motion that closes a gap would pass
   * for slip. Coulomb's law allows any |Lambda| <= 1 in stick. Of these the
   * value of the last accepted step is kept (ContactPoint::restrained), which
   * is 0 at points that have never slipped, as it has to be on a symmetry
   * plane. Points that constraints drive against each other are not restrained:
   * they slip.
   *
   * A point is restrained only if all points that share a multiplier node with
   * it are. @p constraints are those of the increment, @p accepted_multipliers
   * are ghosted, of the last accepted step. Collective.
   */
  template <int dim>
  void
  update_restrained_directions(ContactAssembler<dim> &contact,
                               const Constraints     &constraints,
                               const LA::Vector      &accepted_multipliers);
} // namespace stickslip

#endif
