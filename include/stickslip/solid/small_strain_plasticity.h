#ifndef stickslip_solid_small_strain_plasticity_h
#define stickslip_solid_small_strain_plasticity_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>
#include <stickslip/solid/isotropic_hardening.h>
#include <stickslip/solid/kinematic_hardening.h>

#include <string>
#include <vector>

namespace stickslip
{
  enum class StrainMeasure
  {
    small,
    green_lagrange
  };

  /**
   * Von Mises plasticity with an additive split of the strain, isotropic
   * hardening R(p) and kinematic hardening (KinematicHardening), separately or
   * mixed:
   *
   *   |stress - X|_vM <= R(p),   X = 2/3 C e_p + sum X_k.
   *
   * With "small" strains it is for small rotations, too: P = stress(sym F - I).
   * With "Green-Lagrange" strains the same relation is between Green-Lagrange
   * strain and second Piola-Kirchhoff stress, P = F S(E): rotations may be
   * large, strains have to stay small (some percent). For large strains take a
   * law with a multiplicative split.
   *
   * History: the equivalent plastic strain, the plastic strain, and the back
   * stresses with recovery.
   */
  class SmallStrainPlasticity : public ConstitutiveLaw
  {
  public:
    void
    add_parameters(ParameterHandler &prm) override;

    void
    read_files(const std::string &path,
               const std::string &directory,
               const MPI_Comm     communicator) override;

    void
    check(const std::string &path) const override;

    std::vector<std::string>
    history_names() const override;

    /// Returns false if det F <= 0 with Green-Lagrange strains.
    bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const override;

    SymmetricTensor<2, 3>
    cauchy_stress(const Tensor<2, 3> &F, const Tensor<2, 3> &P) const override;

    SymmetricTensor<2, 3>
    strain(const Tensor<2, 3> &F) const override;

    double
    longitudinal_modulus() const override;

    bool
    is_geometrically_linear() const override;

    ElasticConstants   constants;
    IsotropicHardening hardening;
    KinematicHardening kinematic;
    StrainMeasure      strain_measure = StrainMeasure::small;
  };
} // namespace stickslip

#endif
