#ifndef stickslip_contact_point_contact_parameters_h
#define stickslip_contact_point_contact_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

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
    /// equations (formulation 3.3).
    double
    status_over_law() const
    {
      return r_t_status / r_t_law;
    }
  };



  /**
   * The six regularization parameters (formulation 3.3): factors of the
   * automatic scales or of the paper's bounds, or plain numbers with units.
   */
  struct RegularizationParameters
  {
    std::string scale            = "automatic";
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

    /// With the meaning that `automatic` has for the rule @p quadrature.
    RegularizationFactors
    factors(const std::string &quadrature) const;

    void
    check(const std::string &path, const std::string &quadrature) const;
  };



  /**
   * One pair of surfaces that may touch: who is slave and master, the law
   * between them and how it is discretized.
   */
  struct ContactPairParameters
  {
    std::string               slave_body;
    std::vector<unsigned int> slave_boundary;
    std::string               master_body;
    std::vector<unsigned int> master_boundary;

    std::string friction             = "none";
    double      friction_coefficient = 0.;
    double      tresca_threshold     = 0.;
    std::string threshold_form       = "augmented";

    std::string  multiplier_space = "displacement trace";
    std::string  quadrature       = "nodal";
    unsigned int quadrature_order = 2;

    std::string               normals              = "facet";
    double                    smoothing_angle      = 60.;
    double                    search_distance      = 0.;
    double                    projection_tolerance = 0.05;
    double                    facet_overlap        = 0.01;
    double                    end_overlap          = 0.5;
    std::string               gap_offset           = "0";
    std::vector<unsigned int> excluded_boundaries;
    std::string               excluded_points;

    RegularizationParameters regularization;

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// True if the pair carries tangential traction.
    bool
    has_friction() const
    {
      return friction != "none";
    }
  };
} // namespace stickslip

#endif
