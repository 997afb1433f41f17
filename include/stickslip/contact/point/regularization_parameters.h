#ifndef stickslip_contact_point_regularization_parameters_h
#define stickslip_contact_point_regularization_parameters_h

#include <stickslip/base/choice.h>

#include <stickslip/contact/surface/contact_quadrature.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

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



  /// Factors of the automatic scales.
  struct DefaultFactors
  {
    double r_n = 1.;
    double r_t = 1.;
  };

  /// What `automatic` stands for with @p rule.
  DefaultFactors
  default_factors(const ContactRule rule);



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
} // namespace stickslip

#endif
