#ifndef stickslip_contact_point_tangent_stabilization_h
#define stickslip_contact_point_tangent_stabilization_h

#include <stickslip/contact/point/contact_element.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace stickslip
{
  /**
   * What is added to the tangent, never to the residual, where the law's own
   * derivative leaves something undetermined. The answer stays the same.
   */

  /// Before any pressure there is no friction threshold, and a body that only
  /// friction holds would be free: in that first iteration closed points are
  /// held by a weak tangential spring.
  template <int dim>
  void
  assume_stick_before_first_pressure(const ContactPoint<dim> &point,
                                     ContactEvaluation<dim>  &state);

  /// A mortar node that touches although its average is open holds a body that
  /// nothing else holds, by a normal spring (ContactScales::initial_contact).
  template <int dim>
  void
  hold_touching_node(const ContactPoint<dim> &point,
                     ContactEvaluation<dim>  &state);

  /// A sticking node whose tangential displacement is prescribed leaves Lambda
  /// undetermined: it keeps the value that it has. @p multiplier_shape are the
  /// values at the point of the last multipliers of @p local.
  template <int dim>
  void
  keep_undetermined_Lambda(const ContactPoint<dim>      &point,
                           const ContactEvaluation<dim> &state,
                           const std::vector<double>    &multiplier_shape,
                           const unsigned int            n_components,
                           FullMatrix<double>           &local);
} // namespace stickslip

#endif
