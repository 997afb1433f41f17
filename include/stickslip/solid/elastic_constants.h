#ifndef stickslip_solid_elastic_constants_h
#define stickslip_solid_elastic_constants_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  /**
   * Young's modulus and Poisson's ratio of an isotropic law, with the Lame
   * constants that follow from them.
   */
  struct ElasticConstants
  {
    double youngs_modulus = 1.;
    double poissons_ratio = 0.3;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Throws UserError unless E > 0 and -1 < nu < 1/2.
    void
    check(const std::string &path) const;

    /// lambda = E nu / ((1 + nu) (1 - 2 nu))
    double
    lame_lambda() const;

    /// K = E / (3 (1 - 2 nu))
    double
    bulk_modulus() const;

    /// mu = E / (2 (1 + nu))
    double
    shear_modulus() const;
  };
} // namespace stickslip

#endif
