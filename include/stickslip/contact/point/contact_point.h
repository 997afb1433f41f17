#ifndef stickslip_contact_point_contact_point_h
#define stickslip_contact_point_contact_point_h

#include <stickslip/contact/point/contact_law.h>
#include <stickslip/contact/point/contact_state.h>
#include <stickslip/contact/point/pairing_hysteresis.h>
#include <stickslip/contact/point/restrained_slip.h>

#include <optional>
#include <vector>

namespace stickslip
{
  /// Where a contact (quadrature) point is on the undeformed slave surface.
  template <int dim>
  struct PointGeometry
  {
    unsigned int   slave_face       = 0;
    unsigned int   quadrature_index = 0;
    unsigned int   mortar_node      = 0; ///< with `Quadrature = segments`
    double         weight = 0.;          ///< quadrature weight x reference area
    Tensor<1, dim> reference_position;
    /// Derivative of the slave shape functions along the first reference
    /// tangent: carries the tangent basis (3D).
    std::vector<double> direction_gradients;
    /// Turns nodal Lambda components into those at this point, per multiplier
    /// node, where nothing is deformed.
    std::vector<Tensor<2, dim - 1>> reference_rotations;
  };



  /// What outer loops may freeze besides the pairing.
  struct FrozenQuantities
  {
    bool   closed    = false; ///< S_c
    double threshold = 0.;    ///< s [stress]
  };



  /// What the regularization parameters of a point are measured by, constant
  /// during a Newton iteration (assembly/contact_scales.h).
  struct ContactScales
  {
    double stiffness = 1.; ///< k of the contact [stress/length]: unit of r_n
    double threshold = 1.; ///< s, or the least one that r_t follows [stress]
    double stiffness_over_threshold = 1.; ///< unit of r_t [1/length]
    double default_r_n = 1.; ///< that the rule has by itself [stress/length]
    double default_r_t = 1.; ///< likewise [1/length]
    double negligible_pressure = 0.; ///< up to here it is roundoff [stress]
    double open_row = 1.; ///< of Lambda where a point is open [stress length]
    /// Tangential stiffness in the tangent as long as no point has a threshold
    /// [stress/length].
    double initial_stick = 0.;
    /// Normal stiffness in the tangent of a mortar node that touches although
    /// its average is open, as long as nothing is closed [stress/length].
    double initial_contact = 0.;
  };



  /// What the treatment of cycles has changed at a point
  /// (cycling/status_cycle_treatment.h).
  struct PointCycleTreatment
  {
    double              r_n_factor = 1.;
    double              r_t_factor = 1.;
    std::optional<bool> fixed_closed; ///< S_c until the residual has converged
    std::optional<bool> fixed_stick;  ///< S_f
    unsigned int        n_treatments = 0; ///< in the present solve
    unsigned int        n_fixed      = 0; ///< likewise

    /// Frees the statuses. True if one was fixed.
    bool
    release()
    {
      const bool was_fixed = fixed_closed || fixed_stick;
      fixed_closed.reset();
      fixed_stick.reset();
      return was_fixed;
    }
  };



  /// One contact point: its parts, each with one owner that changes it.
  template <int dim>
  struct ContactPoint
  {
    PointGeometry<dim> geometry;        ///< never changes
    double             gap_offset = 0.; ///< of this step [length]

    /// In the present configuration: a function of the state and of the
    /// hysteresis (ContactAssembler::configure).
    Pairing<dim>           pairing;
    PairingHysteresis<dim> hysteresis;
    InitialPairing<dim>    initial_pairing; ///< of this step

    FrozenQuantities frozen;

    // constant during a Newton iteration
    ContactScales  scales;
    Regularization regularization;
    /// PointGeometry::reference_rotations for the present deformation
    /// (assembly/nodal_frames.h).
    std::vector<Tensor<2, dim - 1>> nodal_rotations;
    RestrainedSlip<dim>             restrained;

    ObservedState<dim>  observed; ///< by the last residual or tangent
    PointCycleTreatment treatment;

    Tensor<1, dim> accumulated_slip; ///< history [length]
  };
} // namespace stickslip

#endif
