#ifndef stickslip_contact_assembly_contact_scales_h
#define stickslip_contact_assembly_contact_scales_h

#include <stickslip/contact/assembly/contact_assembler.h>

namespace stickslip
{
  /**
   * k = 1/(h_s/M_s + h_m/M_m) at a point [stress/length]: the cells on both
   * sides, of height h and longitudinal modulus M, as springs in a row. An
   * unpaired point has no second cell.
   */
  template <int dim>
  double
  contact_stiffness(const ContactPair<dim>  &pair,
                    const ContactPoint<dim> &point);



  /**
   * Renews the six regularization parameters of all points from the stiffness
   * of both sides and the present pressures. With the automatic scale they do
   * not depend on units or mesh: r_n = f_n k and r_t = f_t k / s with
   * k = 1/(h_s/M_s + h_m/M_m) and s the friction threshold at the point, at
   * least a hundredth of the largest one. They are constants for one Newton
   * iteration and change nothing in the solution (doc/theory.md, section 3), so
   * they may follow the pressure. Collective.
   */
  template <int dim>
  void
  update_contact_scales(ContactAssembler<dim> &contact);



  /// Largest pressure that is nothing but the roundoff of a gap, of all points.
  /// Collective.
  template <int dim>
  double
  negligible_pressure(const ContactAssembler<dim> &contact);
} // namespace stickslip

#endif
