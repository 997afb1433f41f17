#ifndef stickslip_solid_simo_miehe_h
#define stickslip_solid_simo_miehe_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>
#include <stickslip/solid/isotropic_hardening.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Finite elastoplasticity F = F^e F^p after Simo and Miehe (CMAME 98, 1992),
   * von Mises yield condition on the Kirchhoff stress, isotropic hardening:
   *
   *   tau = K/2 (J^2 - 1) I + mu dev(b),   b = J^(-2/3) F^e F^eT,
   *   -1/2 L_v(b^e) (b^e)^-1 = 3/2 p' dev(tau) / |tau|_vM.
   *
   * The associated flow rule is integrated with the exponential map in the
   * principal axes of the trial state: plastic flow conserves the volume
   * exactly, and proportional loading is integrated exactly. (The radial return
   * of Simo (CMAME 66, 1988) replaces b^e in the flow rule by tr(b^e)/3 I.
   * That is the same for metals, whose elastic strains are small; with elastic
   * strains of 30 % it converges to plastic strains that differ by 20 %.)
   *
   * History: the equivalent plastic strain, and (F^pT F^p)^-1 with determinant
   * 1, which lives in the undeformed body and so does not feel rotations.
   */
  class SimoMiehe : public ConstitutiveLaw
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

    /// Returns false if det F <= 0 or if the return mapping finds no end state.
    bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const override;

    double
    longitudinal_modulus() const override;

    ElasticConstants   constants;
    IsotropicHardening hardening;

  private:
    /// For a trial state beyond the yield surface.
    bool
    evaluate_plastic(const Tensor<2, 3>            &F,
                     const double                   J,
                     const ArrayView<const double> &old_history,
                     const ArrayView<double>       &new_history,
                     Tensor<2, 3>                  &P,
                     Tensor<4, 3>                  *dP_dF) const;
  };
} // namespace stickslip

#endif
