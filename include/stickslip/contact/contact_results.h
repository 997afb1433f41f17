#ifndef stickslip_contact_contact_results_h
#define stickslip_contact_contact_results_h

#include <stickslip/contact/contact_assembler.h>
#include <stickslip/contact/contact_result.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// Largest violations of the contact law at any contact point.
  struct ContactViolation
  {
    double penetration = 0.; ///< [length]
    double tension     = 0.; ///< [stress]
    double disc        = 0.; ///< |Lambda| - 1
    double stick_slip  = 0.; ///< slip of the step at sticking points [length]
    double direction   = 0.; ///< |Lambda - direction of slip| where it slips
  };

  /// State of the locally owned slave faces in the present configuration.
  template <int dim>
  std::vector<ContactFaceResult<dim>>
  contact_results(ContactAssembler<dim> &contact);

  /**
   * Checks the present state against the contact law at every contact point,
   * with statuses taken afresh from multipliers and gap, whatever the algorithm
   * had frozen. With more contact points than multipliers the law holds weakly,
   * so small pointwise violations are part of the discretization. Collective.
   */
  template <int dim>
  ContactViolation
  contact_violation(ContactAssembler<dim> &contact);

  /// Says for a failed step where contact points are and what they do: the
  /// number in each state and the point with the largest gap error. Collective.
  template <int dim>
  std::string
  describe_contact(ContactAssembler<dim> &contact);
} // namespace stickslip

#endif
