#ifndef stickslip_contact_point_contact_law_h
#define stickslip_contact_point_contact_law_h

#include <stickslip/contact/point/contact_kinematics.h>

#include <array>

namespace stickslip
{
  /// The six regularization parameters at one contact point, with units.
  struct Regularization
  {
    double r_n_status       = 1.; ///< r_n^{Sc} [stress/length]
    double r_n_augmentation = 1.; ///< r_n^{A}
    double r_n_law          = 1.; ///< r_n^{Signo}
    double r_t_status       = 1.; ///< r_t^{Sf} [1/length]
    double r_t_augmentation = 1.; ///< r_t^{A}
    double r_t_law          = 1.; ///< r_t^{Coul}
    /// Tangential stiffness in the tangent as long as no point has a threshold
    /// [stress/length].
    double initial_stiffness = 0.;
    double open_scale = 1.; ///< c of the open Lambda rows [stress length]
    double negligible_threshold = 0.; ///< s up to here is roundoff: no friction
    double threshold_scale      = 1.; ///< s or the least one that r_t follows
    double natural_r_n          = 1.; ///< stiffness k of the contact
    double natural_r_t          = 1.; ///< k over the threshold scale
  };

  /// Where the friction threshold s comes from.
  enum class Threshold
  {
    none,      ///< frictionless: no Lambda unknowns
    given,     ///< frozen or Tresca: a number
    augmented, ///< -mu (lambda_n - r_n^A d_n), live
    plain      ///< -mu lambda_n, live
  };

  /// Contact status of a point: level sets S_c and S_f (paper, eqs. 8 and 9).
  struct ContactStatus
  {
    bool closed = false; ///< S_c
    bool stick  = false; ///< S_f
  };

  /// The unknowns at the point.
  template <int dim>
  struct Multipliers
  {
    double             lambda_n = 0.;
    Tensor<1, dim - 1> Lambda; ///< components on the tangent basis
    /// What Lambda is along held directions (ContactKinematics::held).
    Tensor<1, dim - 1> kept_Lambda;
  };

  /**
   * Weak form at a contact point, per unit weight:
   * traction . dw + row_lambda delta lambda + row_Lambda . delta Lambda, and
   * its derivative with respect to the generalized coordinates.
   */
  template <int dim>
  struct ContactResponse
  {
    using Row = typename GeneralizedCoordinates<dim>::Row;

    Tensor<1, dim>     traction; ///< t: minus the traction on the slave
    double             row_lambda = 0.;
    Tensor<1, dim - 1> row_Lambda;
    double             threshold = 0.; ///< s used

    std::array<Row, dim>     D_traction;
    Row                      D_row_lambda;
    std::array<Row, dim - 1> D_row_Lambda;
  };

  /// S_c = [lambda_n - r_n^{Sc} d_n <= 0].
  bool
  is_closed(const double lambda_n, const double d_n, const Regularization &r);

  /// S_f = [|Lambda + r_t^{Sf} d_t| <= 1].
  template <int dim>
  bool
  is_stick(const Tensor<1, dim> &Lambda,
           const Tensor<1, dim> &d_t,
           const Regularization &r);

  /// Lambda as a vector of the tangent plane.
  template <int dim>
  Tensor<1, dim>
  tangential_vector(const Tensor<1, dim - 1>                  &components,
                    const std::array<Tensor<1, dim>, dim - 1> &tau);

  /**
   * The augmented Lagrangian contact law at a point (formulation 3.3):
   *
   *   t          = -S_c (lambda_n - r_n^A d_n) n + S_c s T(r_t^A)
   *   row_lambda = -(lambda_n - S_c (lambda_n - r_n^S d_n)) / r_n^S
   *   row_Lambda =  S_c s / r_t^C tau . (T(r_t^C) - Lambda) - c (1 - S_c)
   * Lambda
   *
   * with T(r) = Lambda + r d_t in stick and its unit vector in slip. @p mu is
   * the friction coefficient for the live thresholds, @p given_threshold the
   * number s for Threshold::given. Along held directions the Lambda row is
   * Lambda = kept_Lambda instead. Where s = 0 in contact the Lambda row is the
   * open one, so that it is never empty. The derivative (formulation 3.4) is
   * filled if @p differentiate; it is the exact one for fixed statuses.
   */
  template <int dim>
  void
  evaluate_contact_law(const ContactKinematics<dim> &kinematics,
                       const Multipliers<dim>       &multipliers,
                       const ContactStatus          &status,
                       const Threshold               threshold,
                       const double                  mu,
                       const double                  given_threshold,
                       const Regularization         &r,
                       const bool                    differentiate,
                       ContactResponse<dim>         &response);
} // namespace stickslip

#endif
