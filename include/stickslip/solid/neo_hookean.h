#ifndef stickslip_solid_neo_hookean_h
#define stickslip_solid_neo_hookean_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>

#include <string>

namespace stickslip
{
  /**
   * The compressible neo-Hookean law
   * W = mu/2 (tr F^T F - 3 - 2 ln J) + lambda/2 (ln J)^2,
   * P = mu (F - F^-T) + lambda ln J F^-T. Stable under strong compression.
   */
  class NeoHookean : public ConstitutiveLaw
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

    ElasticConstants constants;
  };
} // namespace stickslip

#endif
