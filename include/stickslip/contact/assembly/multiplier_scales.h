#ifndef stickslip_contact_assembly_multiplier_scales_h
#define stickslip_contact_assembly_multiplier_scales_h

#include <stickslip/contact/assembly/contact_assembler.h>

namespace stickslip
{
  /**
   * What the stiffness k of the cells on both sides (contact_stiffness())
   * makes of the multipliers, by integration over the
   * contact points: @p regularization gets the integral of 1/k, at Lambda of
   * s^2/k with the scale s of the friction threshold, because rows of Lambda
   * carry the threshold; @p stiffness gets the integral of k. Both are block vectors
   * [displacements (zero), multipliers], added to with @p constraints and not
   * compressed. Not collective.
   */
  template <int dim>
  void
  add_multiplier_scales(ContactAssembler<dim> &contact,
                        const Constraints     &constraints,
                        LA::BlockVector       &regularization,
                        LA::BlockVector       &stiffness);
} // namespace stickslip

#endif
