#ifndef stickslip_solid_isotropic_hardening_h
#define stickslip_solid_isotropic_hardening_h

#include <stickslip/base/choice.h>
#include <stickslip/base/number_table.h>

#include <stickslip/solid/elastic_constants.h>
#include <stickslip/solid/kinematic_hardening.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <string>
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

  /// The stress that the points of a hardening table have.
  enum class TableOrdinate
  {
    yield_stress,   ///< R, the radius of the yield surface
    uniaxial_stress ///< the curve, R and the kinematic part together
  };

  /**
   * The yield stress R(p) as a function of the equivalent plastic strain p,
   * both as in a uniaxial test (in the law's own stress and strain measures):
   *
   *   none       R = sy
   *   linear     R = sy + H p
   *   tabulated  linear between the points of a table, and on with its last
   *              slope; less the uniaxial back stress at the points if they
   *              have uniaxial stresses
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
    TableOrdinate        table_ordinate   = TableOrdinate::yield_stress;

    NumberTable               table; ///< (strain, stress)
    std::string               table_file;
    std::vector<unsigned int> table_columns = {1, 2};

    /// R and dR/dp
    struct YieldStress
    {
      double value;
      double slope;
    };

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Reads the table's file, if it has one; the name is relative to
    /// @p directory. Collective. Throws UserError, on all ranks.
    void
    read_table_file(const std::string &path,
                    const std::string &directory,
                    const MPI_Comm     communicator);

    /// Throws UserError for values without meaning; @p kinematic as in at().
    void
    check(const std::string        &path,
          const ElasticConstants   &elastic,
          const KinematicHardening &kinematic = KinematicHardening()) const;

    /**
     * The yield stress at p >= 0. Young's modulus is needed where the
     * parameters count elastic strains in (a tangent modulus, a table over
     * the total strain), and the kinematic hardening beside where they contain
     * it (a tangent modulus, a table of uniaxial stresses).
     */
    YieldStress
    at(const double              p,
       const ElasticConstants   &elastic,
       const KinematicHardening &kinematic = KinematicHardening()) const;

  private:
    /// H of linear and Voce: as given, or E E_T / (E - E_T) less the
    /// kinematic part.
    double
    linear_slope(const ElasticConstants   &elastic,
                 const KinematicHardening &kinematic) const;

    /// The plastic strain of a point of the table.
    double
    plastic_strain(const unsigned int point, const double youngs_modulus) const;

    /// R at a point of the table.
    double
    table_yield_stress(const unsigned int        point,
                       const double              youngs_modulus,
                       const KinematicHardening &kinematic) const;

    YieldStress
    interpolate(const double              p,
                const double              youngs_modulus,
                const KinematicHardening &kinematic) const;

    void
    check_table(const std::string        &path,
                const double              youngs_modulus,
                const KinematicHardening &kinematic) const;
  };
} // namespace stickslip

#endif
