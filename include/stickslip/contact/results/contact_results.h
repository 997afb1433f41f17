#ifndef stickslip_contact_results_contact_results_h
#define stickslip_contact_results_contact_results_h

#include <stickslip/contact/assembly/contact_assembler.h>
#include <stickslip/contact/results/contact_result.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// State of the locally owned slave faces in the present configuration.
  template <int dim>
  std::vector<ContactFaceResult<dim>>
  contact_results(ContactAssembler<dim> &contact);

  /// What the points of @p face have of @p quantity, averaged at its nodes; zero
  /// at a node without a point.
  template <int dim>
  std::vector<Tensor<1, dim>>
  nodal_averages(const ContactFaceResult<dim> &face,
                 Tensor<1, dim> ContactPointResult<dim>::*quantity);

  /// Says for a failed step where contact points are and what they do: the
  /// number in each state and the point with the largest gap error. Collective.
  template <int dim>
  std::string
  describe_contact(ContactAssembler<dim> &contact);
} // namespace stickslip

#endif
