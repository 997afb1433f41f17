#ifndef stickslip_contact_results_neighbour_points_h
#define stickslip_contact_results_neighbour_points_h

#include <stickslip/contact/assembly/contact_assembler.h>
#include <stickslip/contact/results/contact_result.h>

namespace stickslip
{
  /**
   * Gives each slave face of pair @p p, which has segments, what is known at
   * those of its multiplier nodes whose point belongs to another face, of this
   * rank or of another. @p faces are the results of the owned slave faces of
   * the pair with their points. Collective.
   */
  template <int dim>
  void
  add_points_of_neighbours(const ContactAssembler<dim> &contact,
                           const unsigned int           p,
                           ContactFaceResult<dim>      *faces);
} // namespace stickslip

#endif
