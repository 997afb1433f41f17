#ifndef stickslip_solid_isotropic_hardening_h
#define stickslip_solid_isotropic_hardening_h

#include <stickslip/base/choice.h>

#include <stickslip/solid/elastic_constants.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  enum class HardeningType
  {
    none,
    linear,
    tabulated,
    power,
    voce
  };

  const Choices<HardeningType> &
  all_hardening_types();

  /// What a hardening modulus is the slope of.
  enum class HardeningModulusType
  {
    slope,          ///< yield stress over plastic strain
    tangent_modulus ///< the uniaxial curve over the total strain
  };

  /// The strain that the points of a hardening table have.
  enum class TableAbscissa
  {
    plastic_strain,
    total_strain
  };

  /**
   * The yield stress R(p) as a function of the equivalent plastic strain p,
   * both as in a uniaxial test (in the law's own stress and strain measures):
   *
   *   none       R = sy
   *   linear     R = sy + H p
   *   tabulated  linear between the points of a table, and on with its last
   *              slope
   *   power      R = sy (1 + p / p0)^n
   *   Voce       R = sy + (s_inf - sy) (1 - exp(-p / p0)) + H p
   *
   * It never falls, so that a return mapping always has one solution.
   */
  struct IsotropicHardening
  {
    HardeningType        type             = HardeningType::none;
    double               yield_stress     = 1.;
    double               modulus          = 0.;
    HardeningModulusType modulus_type     = HardeningModulusType::slope;
    double               reference_strain = 0.01;
    double               exponent         = 0.2;
    double               saturation       = 1.;
    TableAbscissa        table_abscissa   = TableAbscissa::plastic_strain;

    std::vector<std::pair<double, double>> table;

    /// R and dR/dp
    struct YieldStress
    {
      double value;
      double slope;
    };

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Throws UserError for values without meaning; @p kinematic_slope as in
    /// at().
    void
    check(const std::string      &path,
          const ElasticConstants &elastic,
          const double            kinematic_slope = 0.) const;

    /**
     * The yield stress at p >= 0. Young's modulus is needed where the
     * parameters count elastic strains in (a tangent modulus, a table over
     * the total strain), and @p kinematic_slope, the uniaxial modulus of the
     * kinematic hardening beside, where a tangent modulus contains it.
     */
    YieldStress
    at(const double            p,
       const ElasticConstants &elastic,
       const double            kinematic_slope = 0.) const;

  private:
    /// H of linear and Voce: as given, or E E_T / (E - E_T) less the
    /// kinematic part.
    double
    linear_slope(const ElasticConstants &elastic,
                 const double            kinematic_slope) const;

    YieldStress
    interpolate(const double p, const double youngs_modulus) const;

    void
    check_table(const std::string &path, const double youngs_modulus) const;
  };
} // namespace stickslip

#endif
