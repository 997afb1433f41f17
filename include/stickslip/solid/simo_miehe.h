#ifndef stickslip_solid_simo_miehe_h
#define stickslip_solid_simo_miehe_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>
#include <stickslip/solid/isotropic_hardening.h>

namespace stickslip
{
  /**
   * Finite elastoplasticity F = F^e F^p after Simo and Miehe, von Mises yield
   * condition on the Kirchhoff stress, isotropic hardening:
   *
   *   tau = K/2 (J^2 - 1) I + mu dev(b),   b = J^(-2/3) F^e F^eT.
   *
   * Radial return with the trial b (Simo, CMAME 66, 1988, and 68), where
   * mu tr(b)/3 takes the place of mu. The radial return alone would lose
   * det b = 1; here the spherical part of the new b is the one that keeps it.
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
    check(const std::string &path) const override;

    std::vector<std::string>
    history_names() const override;

    void
    initialize_history(const ArrayView<double> &history) const override;

    /// Returns false if det F <= 0 or if no b with determinant 1 is found.
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
  };
} // namespace stickslip

#endif
