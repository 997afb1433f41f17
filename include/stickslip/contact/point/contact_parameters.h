#ifndef stickslip_contact_point_contact_parameters_h
#define stickslip_contact_point_contact_parameters_h

#include <stickslip/base/choice.h>

#include <stickslip/contact/point/initial_gaps.h>
#include <stickslip/contact/point/pair_law.h>
#include <stickslip/contact/point/regularization_parameters.h>
#include <stickslip/contact/surface/contact_quadrature.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/types.h>

#include <set>
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
    automatic, ///< vertices on quadratic triangles and, with segments, in
               ///< sections of bodies of revolution, else the trace
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

  /// What the facets of straight cells stand for, with segments.
  enum class Facets
  {
    curved, ///< a smooth surface (facet_rise.h)
    flat    ///< themselves
  };

  const Choices<Facets> &
  all_facets();

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

    PairLaw       law                  = PairLaw::contact;
    Friction      friction             = Friction::none;
    double        friction_coefficient = 0.;
    double        tresca_threshold     = 0.;
    ThresholdForm threshold_form       = ThresholdForm::augmented;

    MultiplierSpace    multiplier_space = MultiplierSpace::automatic;
    ContactRule        quadrature       = ContactRule::segments;
    unsigned int       quadrature_order = 2;
    WeightingFunctions weighting        = WeightingFunctions::dual;

    Facets                   facets               = Facets::curved;
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

    // of a pair that the user has not named (problem/automatic_pairs.h)
    bool                         is_automatic = false;
    std::set<types::boundary_id> slave_ids;          ///< of the triangulation
    std::set<types::boundary_id> master_ids;         ///< likewise
    double                       least_cosine = 0.1; ///< PairingTolerances

    RegularizationParameters regularization;

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// What a pair that cannot part has no use for.
    void
    check_bilateral(const std::string &path) const;

    /// What a surface that meets itself cannot have. Throws UserError.
    void
    check_self_contact(const std::string &path) const;

    /// Whether one of the pair's surfaces belongs to @p body.
    bool
    involves(const std::string &body) const
    {
      return slave_body == body || master_body == body;
    }

    bool
    is_tied() const
    {
      return law == PairLaw::tied;
    }

    /// True if the surfaces cannot part: tied, or no separation.
    bool
    is_bilateral() const
    {
      return stickslip::is_bilateral(law);
    }

    /// True if the pair carries tangential traction, by friction or tied.
    bool
    has_tangential_traction() const
    {
      return friction != Friction::none || is_tied();
    }

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

    /// True if gaps are those of the smooth surfaces behind the facets.
    bool
    has_curved_facets() const
    {
      return facets == Facets::curved && has_segments();
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
