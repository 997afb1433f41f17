#ifndef stickslip_contact_point_restrained_slip_h
#define stickslip_contact_point_restrained_slip_h

#include <stickslip/contact/point/contact_law.h>

#include <vector>

namespace stickslip
{
  /**
   * Tangential directions along which constraints leave a point no slip
   * (assembly/restrained_directions.h), and the value of Lambda there, which no
   * unknown determines. Constant during a Newton iteration.
   */
  template <int dim>
  struct RestrainedSlip
  {
    std::vector<Tensor<1, dim>> directions; ///< orthonormal, at most dim - 1
    Tensor<1, dim - 1>          Lambda;     ///< on the tangent basis
  };



  /**
   * Takes the slip along @p directions, projected on the tangent plane, out of
   * @p kinematics; out of the derivative, too, if @p differentiate. None of the
   * directions may be normal. Returns the projector on what is taken out (zero
   * without directions).
   */
  template <int dim>
  Tensor<2, dim>
  restrain_slip(const std::vector<Tensor<1, dim>> &directions,
                const bool                         differentiate,
                ContactKinematics<dim>            &kinematics);

  /**
   * Replaces what the law has put into the rows of Lambda along the restrained
   * directions by s / r_t^C (Lambda_restrained - Lambda): Coulomb's law leaves
   * Lambda undetermined there. @p projector is that of restrain_slip(). Does
   * nothing to a point that is open or has no threshold.
   */
  template <int dim>
  void
  restrain_Lambda(const ContactKinematics<dim> &kinematics,
                  const Multipliers<dim>       &multipliers,
                  const Tensor<2, dim>         &projector,
                  const Tensor<1, dim - 1>     &restrained_Lambda,
                  const double                  r_t_law,
                  const bool                    differentiate,
                  ContactResponse<dim>         &response);
} // namespace stickslip

#endif
