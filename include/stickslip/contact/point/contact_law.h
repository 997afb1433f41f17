#ifndef stickslip_contact_point_contact_law_h
#define stickslip_contact_point_contact_law_h

#include <stickslip/contact/point/contact_kinematics.h>
#include <stickslip/contact/point/law_corners.h>

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
  };

  /// Where the friction threshold s comes from.
  enum class ThresholdKind
  {
    none,      ///< frictionless: no Lambda unknowns
    given,     ///< frozen or Tresca: a number
    augmented, ///< -mu (lambda_n - r_n^A d_n), live
    plain      ///< -mu lambda_n, live
  };

  /// The friction threshold of a point.
  struct FrictionThreshold
  {
    ThresholdKind kind                 = ThresholdKind::none;
    double        friction_coefficient = 0.; ///< mu of the live kinds
    double        given                = 0.; ///< s [stress]
    double negligible = 0.; ///< s up to here is roundoff: no friction [stress]
  };

  /// What the law at a point depends on besides unknowns and kinematics.
  struct PointLaw
  {
    Regularization    r;
    FrictionThreshold threshold;
    double            open_row = 1.; ///< c of open Lambda rows [stress length]
    LawRounding       rounding;
    /// T = Lambda at the solution, not only in the mean over points.
    bool holds_at_point = false;
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
    double             threshold = 0.;     ///< s used
    Tensor<1, dim>     friction_direction; ///< T(r_t^A): the force is s T

    std::array<Row, dim>     D_traction;
    Row                      D_row_lambda;
    Row                      D_threshold;
    std::array<Row, dim - 1> D_row_Lambda;
  };

  /// Coulomb's threshold mu max(-(lambda_n - r_n d_n), 0) [stress].
  double
  augmented_threshold(const double friction_coefficient,
                      const double lambda_n,
                      const double r_n,
                      const double d_n);

  /// S_c = [lambda_n - r_n^{Sc} d_n <= 0], up to a pressure of roundoff: what
  /// touches is closed.
  bool
  is_closed(const double          lambda_n,
            const double          d_n,
            const Regularization &r,
            const double          negligible = 0.);

  /// S_f = [|Lambda + r_t^{Sf} d_t| <= 1], up to roundoff.
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
   * with T(r) = Lambda + r d_t in stick and its unit vector in slip. Where
   * s = 0 in contact the Lambda row is the open one, so that it is never empty.
   * With rounded corners (law_corners.h) S_c g and T are their smooth
   * counterparts, and every point has a pressure and a friction force.
   *
   * The derivative (formulation 3.4) is filled if @p differentiate. It is the
   * exact one for fixed statuses; but where T = Lambda holds at the point
   * itself, that of the Lambda row leaves out (T - Lambda) Ds, which vanishes
   * at the solution: Newton's method then sees the row divided by s.
   * Constraints that restrain the slip act on the kinematics before and on the
   * response after (restrained_slip.h).
   */
  template <int dim>
  void
  evaluate_contact_law(const PointLaw               &law,
                       const ContactKinematics<dim> &kinematics,
                       const Multipliers<dim>       &multipliers,
                       const ContactStatus          &status,
                       const bool                    differentiate,
                       ContactResponse<dim>         &response);
} // namespace stickslip

#endif
