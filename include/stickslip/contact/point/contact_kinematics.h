#ifndef stickslip_contact_point_contact_kinematics_h
#define stickslip_contact_point_contact_kinematics_h

#include <stickslip/contact/point/pairing.h>

#include <stickslip/contact/surface/master_geometry.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * The few quantities through which the nodal unknowns enter a contact point.
   * Everything at the point is differentiated with respect to these:
   *
   * - W: x_s - xbar at fixed xi (dim);
   * - C_alpha: d xbar / d xi_alpha at fixed xi (dim each);
   * - M: interpolated nodal normal at fixed xi (dim; smoothed normals only);
   * - E: slave direction that carries the tangent basis (dim; 3D only);
   * - lambda_n, and the components of Lambda on the tangent basis.
   */
  template <int dim>
  struct GeneralizedCoordinates
  {
    static constexpr unsigned int W      = 0;
    static constexpr unsigned int C      = W + dim;
    static constexpr unsigned int M      = C + dim * (dim - 1);
    static constexpr unsigned int E      = M + dim;
    static constexpr unsigned int lambda = E + dim;
    static constexpr unsigned int Lambda = lambda + 1;
    static constexpr unsigned int n      = Lambda + dim - 1;
    /// A mortar node has a motion of its own beside W, and no C_alpha.
    static constexpr unsigned int motion = C;

    /// Rows that a contact point produces: W, C_alpha, lambda, Lambda.
    using Row = std::array<double, n>;
  };



  /// Derivative of a vector: one row per component.
  template <int dim>
  using VectorRows = std::array<typename GeneralizedCoordinates<dim>::Row, dim>;

  /// The slave's side of a contact point, now and at the start of the step.
  template <int dim>
  struct SlavePosition
  {
    Tensor<1, dim> x;
    Tensor<1, dim> x_old;
    Tensor<1, dim> direction; ///< E (unused in 2D)
    double         gap_offset = 0.;
  };

  /**
   * Gap, slip increment and frame of a contact point, with derivatives with
   * respect to the generalized coordinates (doc/theory.md, section 5).
   */
  template <int dim>
  struct ContactKinematics
  {
    using Row = typename GeneralizedCoordinates<dim>::Row;

    double         d_n = 0.; ///< <= 0 open
    Tensor<1, dim> d_t;      ///< slip of the step, slave - master
    Tensor<1, dim> motion;   ///< w: the step's relative motion, slave - master

    Tensor<1, dim>                      n;
    std::array<Tensor<1, dim>, dim - 1> tau;
    std::array<Tensor<1, dim>, dim - 1> a;

    std::array<Row, dim - 1>             D_xi;
    Row                                  D_d_n;
    VectorRows<dim>                      D_n;
    VectorRows<dim>                      D_d_t;
    std::array<VectorRows<dim>, dim - 1> D_tau;
  };

  /// What the gap and the slip of a contact point are made of, with the
  /// derivatives (not filled without differentiation).
  template <int dim>
  struct RelativePosition
  {
    Tensor<1, dim>  r; ///< x_s - x_m
    Tensor<1, dim>  w; ///< its change in the step, with the same partners
    VectorRows<dim> D_r;
    VectorRows<dim> D_w;
  };



  /**
   * Tangent basis of the plane normal to @p n. In 2D n turned by 90 degrees; in
   * 3D tau_1 is the @p direction of the slave projected on the plane (of a fixed
   * axis where that is along n) and tau_2 = n x tau_1. It does not depend on
   * how master facets are numbered and turns with the slave.
   */
  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  tangent_basis(const Tensor<1, dim> &n, const Tensor<1, dim> &direction);

  /**
   * Gap and slip from the relative position, the frame (n, tau) and its
   * derivative D_n, which must be in @p kinematics; with @p geometry_is_live
   * also D_tau. @p direction is E.
   */
  template <int dim>
  void
  evaluate_gap_and_slip(const RelativePosition<dim> &relative,
                        const Tensor<1, dim>        &direction,
                        const double                 gap_offset,
                        const bool                   geometry_is_live,
                        const bool                   differentiate,
                        ContactKinematics<dim>      &kinematics);

  /**
   * Evaluates the kinematics for @p frame. @p master is the master point at
   * frame.xi now, @p master_old at the start of the step. The derivatives are
   * filled only if @p differentiate; with @p geometry_is_live they contain the
   * variations of xi, n and tau, otherwise these are constants.
   */
  template <int dim>
  void
  evaluate_contact_kinematics(const Pairing<dim>       &frame,
                              const MasterPoint<dim>   &master,
                              const MasterPoint<dim>   &master_old,
                              const SlavePosition<dim> &slave,
                              const bool                smoothed_normals,
                              const bool                geometry_is_live,
                              const bool                differentiate,
                              ContactKinematics<dim>   &kinematics);
} // namespace stickslip

#endif
