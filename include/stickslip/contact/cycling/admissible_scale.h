#ifndef stickslip_contact_cycling_admissible_scale_h
#define stickslip_contact_cycling_admissible_scale_h

#include <stickslip/contact/point/contact_state.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * The r_n nearest to @p stiffness (as a factor) at which the status of @p a and
   * that of @p b are the same, both closed or both open:
   * (lambda_a - r d_a)(lambda_b - r d_b) > 0 (paper, eq. 29, in closed form:
   * the product changes its sign at lambda_a / d_a and lambda_b / d_b). It
   * keeps a factor of 2 away from these bounds. 0 if there is none.
   */
  template <int dim>
  double
  admissible_r_n(const StatusState<dim> &a,
                 const StatusState<dim> &b,
                 const double            stiffness);

  /**
   * The same for r_t and stick or slip:
   * (|Lambda_a + r d_a| - 1)(|Lambda_b + r d_b| - 1) > 0 (paper, eq. 32), whose
   * bounds are the roots of two quadratic equations.
   */
  template <int dim>
  double
  admissible_r_t(const StatusState<dim> &a,
                 const StatusState<dim> &b,
                 const double            stiffness);
} // namespace stickslip

#endif
