#ifndef stickslip_solid_hencky_h
#define stickslip_solid_hencky_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>
#include <stickslip/solid/isotropic_hardening.h>
#include <stickslip/solid/kinematic_hardening.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Hencky's elasticity: linear between the logarithmic strain
   * e = 1/2 ln b and the Kirchhoff stress, tau = K tr(e) I + 2 mu dev(e). For
   * large rotations and moderate to large strains.
   */
  class Hencky : public ConstitutiveLaw
  {
  public:
    void
    add_parameters(ParameterHandler &prm) override;

    void
    check(const std::string &path) const override;

    /// Returns false if det F <= 0.
    bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const override;

    /// The logarithmic strain 1/2 ln(F^T F).
    SymmetricTensor<2, 3>
    strain(const Tensor<2, 3> &F) const override;

    double
    longitudinal_modulus() const override;

    ElasticConstants constants;
  };



  /**
   * Finite elastoplasticity F = F^e F^p with Hencky's elasticity of F^e, von
   * Mises yield condition on the Kirchhoff stress, isotropic and kinematic
   * hardening, separately or mixed. The flow rule is integrated with the
   * exponential map, so that plastic flow conserves the volume exactly, and
   * proportional loading is integrated exactly. With isotropic hardening the
   * return mapping is the one of small strains in logarithmic strains (Simo,
   * CMAME 99, 1992); with back stresses, which need not have the principal
   * axes of the strains, it is multiplicative_return().
   *
   * History: the equivalent plastic strain, (F^pT F^p)^-1, and the back
   * stresses with recovery, in the intermediate configuration that
   * (F^pT F^p)^(1/2) leads to. All of them belong to the undeformed body and do
   * not feel rotations.
   */
  class HenckyPlasticity : public Hencky
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

    void
    initialize_history(const ArrayView<double> &history) const override;

    /// Returns false if det F <= 0.
    bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const override;

    IsotropicHardening hardening;
    KinematicHardening kinematic;

  private:
    /// With kinematic hardening.
    bool
    evaluate_mixed(const Tensor<2, 3>            &F,
                   const ArrayView<const double> &old_history,
                   const ArrayView<double>       &new_history,
                   Tensor<2, 3>                  &P,
                   Tensor<4, 3>                  *dP_dF) const;
  };
} // namespace stickslip

#endif
