#ifndef stickslip_solid_kinematic_hardening_h
#define stickslip_solid_kinematic_hardening_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// What a kinematic modulus is.
  enum class KinematicModulusType
  {
    slope,          ///< of the uniaxial back stress over the plastic strain
    prager_constant ///< C of the back stress X = C e_p
  };

  /**
   * One of the back stresses of which the whole is the sum, X_k = 2/3 C a. The
   * back strain a, without unit, follows the plastic strain and is recovered:
   *
   *   da = de_p - gamma a dp   (Armstrong and Frederick, 1966; reprinted in
   *                             Mater. High Temp. 24, 2007).
   *
   * In a uniaxial test C is the initial slope of X_k over the plastic strain,
   * and C/gamma where it ends.
   */
  struct BackStress
  {
    double modulus  = 0.; ///< C, uniaxial; force per area
    double recovery = 0.; ///< gamma; without unit, 0 for Prager's

    /// What a step with the plastic flow A, constant in direction, makes of
    /// the back strain: kept a + gained A. With their slopes over dp.
    struct Evolution
    {
      double kept, gained;
      double kept_slope, gained_slope;
    };

    /**
     * The exact solution for a constant direction of flow,
     * kept = exp(-gamma dp), gained = (1 - kept) / (gamma dp): uniaxial tests
     * need no small steps, and a cannot grow beyond its limit.
     */
    Evolution
    evolution(const double dp) const;
  };

  /**
   * Kinematic hardening with Prager's linear back stress and any number, up
   * to max_back_stresses, of Armstrong and Frederick's with dynamic recovery
   * (Chaboche, Int. J. Plast. 5, 1989): where the yield surface of a plastic
   * material is, its radius being the matter of IsotropicHardening. Laws of
   * small and of large strains share it; what the flow A does to a back strain
   * beside BackStress::Evolution is theirs.
   */
  struct KinematicHardening
  {
    static constexpr unsigned int max_back_stresses = 8;

    /// Back strains, the linear one first.
    using BackStrains =
      std::array<dealii::SymmetricTensor<2, 3>, 1 + max_back_stresses>;

    double               modulus      = 0.;
    KinematicModulusType modulus_type = KinematicModulusType::slope;

    /// (C, gamma), C as modulus_type says
    std::vector<std::pair<double, double>> recovered;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Throws UserError for values without meaning.
    void
    check(const std::string &path) const;

    /// False if there is none.
    bool
    is_active() const;

    /// How many terms there are: the linear one, whose modulus may be 0, and
    /// those with recovery.
    unsigned int
    n_terms() const
    {
      return 1 + recovered.size();
    }

    /// Term @p k, the linear one for 0.
    BackStress
    term(const unsigned int k) const;

    /// Uniaxial slope over the plastic strain that never ends: that of the
    /// linear term.
    double
    slope() const;

    /// The uniaxial back stress after monotonic loading to the plastic strain
    /// @p p >= 0.
    double
    uniaxial_stress(const double p) const;

    /// Appends back_stress_1_xx, ...: of the terms with recovery. (The linear
    /// one follows from the plastic strain.)
    void
    append_history_names(std::vector<std::string> &names) const;

    /// Reads their back strains, whose stresses begin at @p first in @p
    /// history, behind that of the linear term, which is left alone.
    void
    read_back_strains(const dealii::ArrayView<const double> &history,
                      const unsigned int                     first,
                      BackStrains                           &strains) const;

    /// Writes their stresses.
    void
    write_back_stresses(const BackStrains               &strains,
                        const dealii::ArrayView<double> &history,
                        const unsigned int               first) const;

  private:
    /// The uniaxial slope of a modulus as given.
    double
    uniaxial(const double given) const;
  };
} // namespace stickslip

#endif
