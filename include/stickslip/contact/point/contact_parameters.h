#ifndef stickslip_contact_point_contact_parameters_h
#define stickslip_contact_point_contact_parameters_h

#include <stickslip/base/choice.h>

#include <stickslip/contact/point/initial_gaps.h>
#include <stickslip/contact/surface/contact_quadrature.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  enum class Friction
  {
    none,
    Coulomb, ///< threshold mu times the pressure
    Tresca   ///< given threshold
  };

  const Choices<Friction> &
  all_frictions();

  /// What Coulomb's threshold is while it is live.
  enum class ThresholdForm
  {
    augmented, ///< -mu (lambda_n - r_n d_n)
    plain      ///< -mu lambda_n
  };

  const Choices<ThresholdForm> &
  all_threshold_forms();

  enum class MultiplierSpace
  {
    automatic,          ///< vertices on quadratic triangles, else the trace
    displacement_trace, ///< of the degree of the displacement
    vertices            ///< linear
  };

  const Choices<MultiplierSpace> &
  all_multiplier_spaces();

  /// Normals of the master surface.
  enum class Normals
  {
    facet,   ///< the facet's own
    smoothed ///< interpolated from nodal averages
  };

  const Choices<Normals> &
  all_normals();

  /// What the factors of the regularization parameters multiply.
  enum class RegularizationScale
  {
    automatic, ///< stiffness of the contact
    bound,     ///< upper bounds of the paper (eq. 27)
    plain      ///< 1
  };

  const Choices<RegularizationScale> &
  all_regularization_scales();

  /// The six regularization parameters as numbers, in units of their scale.
  struct RegularizationFactors
  {
    double r_n_status       = 1.;
    double r_n_augmentation = 1.;
    double r_n_law          = 1.;
    double r_t_status       = 1.;
    double r_t_augmentation = 1.;
    double r_t_law          = 1.;

    /// Above 2, points that slip against their traction satisfy the discrete
    /// equations (doc/theory.md, section 3).
    double
    status_over_law() const
    {
      return r_t_status / r_t_law;
    }
  };



  /**
   * The six regularization parameters (doc/theory.md, section 3): factors of
   * the automatic scales or of the paper's bounds, or plain numbers with units.
   */
  struct RegularizationParameters
  {
    RegularizationScale scale = RegularizationScale::automatic;

    std::string r_n              = "automatic";
    std::string r_t              = "automatic";
    std::string r_n_status       = "r_n";
    std::string r_n_augmentation = "r_n";
    std::string r_n_law          = "r_n";
    std::string r_t_status       = "r_t";
    std::string r_t_augmentation = "r_t";
    std::string r_t_law          = "r_t";

    void
    add_parameters(ParameterHandler &prm);

    /// With the meaning that `automatic` has for @p rule.
    RegularizationFactors
    factors(const ContactRule rule) const;

    void
    check(const std::string &path, const ContactRule rule) const;
  };



  /**
   * One pair of surfaces that may touch: who is slave and master, the law
   * between them and how it is discretized.
   */
  struct ContactPairParameters
  {
    std::string              slave_body;
    std::vector<std::string> slave_boundary; ///< ids or names
    std::string              master_body;
    std::vector<std::string> master_boundary; ///< ids or names

    Friction      friction             = Friction::none;
    double        friction_coefficient = 0.;
    double        tresca_threshold     = 0.;
    ThresholdForm threshold_form       = ThresholdForm::augmented;

    MultiplierSpace    multiplier_space = MultiplierSpace::automatic;
    ContactRule        quadrature       = ContactRule::segments;
    unsigned int       quadrature_order = 2;
    WeightingFunctions weighting        = WeightingFunctions::dual;

    Normals                  normals              = Normals::smoothed;
    double                   smoothing_angle      = 60.;
    double                   search_distance      = 0.;
    double                   projection_tolerance = 0.05;
    double                   facet_overlap        = 0.01;
    double                   end_overlap          = 0.5;
    std::string              gap_offset           = "0";
    std::vector<std::string> excluded_boundaries; ///< ids or names
    std::string              excluded_points;

    InitialGaps initial_gaps;

    RegularizationParameters regularization;

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// Whether one of the pair's surfaces belongs to @p body.
    bool
    involves(const std::string &body) const
    {
      return slave_body == body || master_body == body;
    }

    /// True if the pair carries tangential traction.
    bool
    has_friction() const
    {
      return friction != Friction::none;
    }

    /// True if averages over segments take the place of contact points.
    bool
    has_segments() const
    {
      return quadrature == ContactRule::segments;
    }

    /// True if the normals are interpolated on the master surface.
    bool
    has_smoothed_normals() const
    {
      return normals == Normals::smoothed && !has_segments();
    }

    /// True if the converged state does not depend on the regularization
    /// parameters: they may then be anything that makes Newton converge.
    bool
    is_independent_of_regularization() const
    {
      return has_one_multiplier_per_point(quadrature);
    }
  };
} // namespace stickslip

#endif
