#ifndef stickslip_contact_results_contact_check_h
#define stickslip_contact_results_contact_check_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <string>

namespace stickslip
{
  /**
   * Largest violations of the contact law at any contact point.
   *
   * The last two are complementarity errors at the stiffness k = 1 / compliance
   * of the contact, whatever r the algorithm worked with:
   * |lambda_n - min(lambda_n - k d_n, 0)| over the largest pressure of the pair
   * (penetration, tension and pressure across a gap), and
   * s |Lambda - P(Lambda + k/s d_t)| over its largest threshold s, P the
   * projection on the unit disc (|Lambda| > 1, slip in stick, slip against
   * Lambda). What would not move a point by a noticeable fraction of its face
   * does not count in them. Surfaces that cannot part count in normal_law, with
   * the distance that they have parted, overlapped or, if tied, slipped.
   */
  struct ContactViolation
  {
    double penetration          = 0.; ///< [length]
    double tension              = 0.; ///< [stress]
    double friction_cone_excess = 0.; ///< |Lambda| - 1
    double stick_slip   = 0.; ///< slip of the step at sticking points [length]
    double direction    = 0.; ///< |Lambda - direction of slip| where it slips
    double normal_law   = 0.;
    double friction_law = 0.;
    /// Points that were paired when the step began, have no partner now, and
    /// lie behind the place where they met it.
    unsigned int fallen_through = 0;
  };

  /// Notes for contact_violation() where the points meet their partners in the
  /// present configuration, that of the beginning of a step.
  template <int dim>
  void
  record_initial_pairings(ContactAssembler<dim> &contact);

  /**
   * Checks the present configuration against the contact law at every contact
   * point; with live quantities everything is taken afresh from multipliers and
   * gap. Pairs with more contact points than multipliers do not contribute to
   * normal_law and friction_law: the law holds weakly there, so pointwise
   * violations are part of the discretization. Collective.
   */
  template <int dim>
  ContactViolation
  contact_violation(ContactAssembler<dim> &contact);
} // namespace stickslip

#endif
