#ifndef stickslip_contact_assembly_friction_multipliers_h
#define stickslip_contact_assembly_friction_multipliers_h

#include <stickslip/contact/assembly/contact_assembler.h>

namespace stickslip
{
  /**
   * Shortens friction multipliers Lambda (@p multipliers, not ghosted) that an
   * increment has thrown far out of the disc of radius one. There only their
   * direction acts, and the longer they are the less the tangent knows of the
   * slip that turns them: where a point with a small threshold slips,
   * lengths of 1e7 occur, and the next iteration is lost. In a state that
   * satisfies Coulomb's law there are none. Pairs whose multipliers are not
   * bound point by point (see has_one_multiplier_per_point()) are left as they
   * are. Collective.
   */
  template <int dim>
  void
  shorten_friction_multipliers(const ContactAssembler<dim> &contact,
                               LA::Vector                  &multipliers);
} // namespace stickslip

#endif
