#ifndef stickslip_solid_hyperelastic_h
#define stickslip_solid_hyperelastic_h

#include <stickslip/solid/constitutive_law.h>

#include <string>

namespace stickslip
{
  /**
   * Rubber: W = C10 (I1 - 3) + C01 (I2 - 3) + C20 (I1 - 3)^2 + K/2 (J - 1)^2
   * with the invariants I1, I2 of the isochoric J^(-2/3) F^T F. C01 = C20 = 0
   * is the neo-Hookean law, C20 = 0 the one of Mooney and Rivlin.
   *
   * At small strains mu = 2 (C10 + C01), so that Poisson's ratio nu means
   * K = 4 (C10 + C01)(1 + nu) / (3 (1 - 2 nu)).
   */
  class Hyperelastic : public ConstitutiveLaw
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

    double
    longitudinal_modulus() const override;

    /// K, as given or from Poisson's ratio.
    double
    bulk_modulus() const;

    double C10                = 1.;
    double C01                = 0.;
    double C20                = 0.;
    double poissons_ratio     = 0.3;
    double given_bulk_modulus = 0.; ///< 0: from Poisson's ratio
  };
} // namespace stickslip

#endif
