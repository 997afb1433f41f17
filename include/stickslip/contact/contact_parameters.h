#ifndef stickslip_contact_contact_parameters_h
#define stickslip_contact_contact_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Dimensionless r_t where the user gives none. Nodal quadrature: GNM takes
  /// the fewest iterations with 1 to 2 where surfaces slide, and cuts steps
  /// with 0.25 and 0.5. Other rules: smaller, because the answer drifts with
  /// it.
  inline double
  automatic_r_t(const std::string &quadrature)
  {
    return quadrature == "nodal" ? 1. : 0.25;
  }

  /**
   * The six regularization parameters (formulation 3.3), as factors of the
   * automatic scales or as plain numbers with units.
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

    /// @p automatic_r_t is what `r_t = automatic` means here.
    void
    check(const std::string &path, const double automatic_r_t) const;
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
