#ifndef stickslip_solid_saint_venant_kirchhoff_h
#define stickslip_solid_saint_venant_kirchhoff_h

#include <stickslip/solid/constitutive_law.h>
#include <stickslip/solid/elastic_constants.h>

#include <string>

namespace stickslip
{
  /**
   * St Venant-Kirchhoff: the linear law between Green-Lagrange strain
   * E = (F^T F - I)/2 and second Piola-Kirchhoff stress
   * S = lambda tr(E) I + 2 mu E, P = F S. For large rotations and moderate
   * strains: in uniaxial compression the load has its maximum at a stretch of
   * 1/sqrt(3), below which the law softens.
   */
  class SaintVenantKirchhoff : public ConstitutiveLaw
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
