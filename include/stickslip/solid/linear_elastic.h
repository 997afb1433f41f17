#ifndef stickslip_solid_linear_elastic_h
#define stickslip_solid_linear_elastic_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>

#include <string>

namespace stickslip
{
  /**
   * Isotropic linear elasticity at small strains,
   * sigma = lambda tr(eps) I + 2 mu eps with eps = sym(F) - I. It does not
   * distinguish configurations: P = sigma.
   */
  class LinearElastic : public ConstitutiveLaw
  {
  public:
    void
    add_parameters(ParameterHandler &prm) override;

    void
    check(const std::string &path) const override;

    bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const override;

    SymmetricTensor<2, 3>
    cauchy_stress(const Tensor<2, 3> &F, const Tensor<2, 3> &P) const override;

    /// The small strain.
    SymmetricTensor<2, 3>
    strain(const Tensor<2, 3> &F) const override;

    double
    longitudinal_modulus() const override;

    bool
    is_geometrically_linear() const override
    {
      return true;
    }

    bool
    is_linear() const override
    {
      return true;
    }

    ElasticConstants constants;
  };
} // namespace stickslip

#endif
