#include <stickslip/solid/elastic_constants.h>

#include <stickslip/base/user_error.h>

#include <sstream>

namespace stickslip
{
  void
  ElasticConstants::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Young's modulus",
                      youngs_modulus,
                      "Force per area; greater than zero.",
                      dealii::Patterns::Double());
    prm.add_parameter("Poisson's ratio",
                      poissons_ratio,
                      "Between -1 and 0.5, both excluded.",
                      dealii::Patterns::Double());
  }



  void
  ElasticConstants::check(const std::string &path) const
  {
    std::ostringstream text;
    if (!(youngs_modulus > 0.))
      {
        text << path << "/Young's modulus is " << youngs_modulus
             << ", but has to be greater than 0.";
        throw UserError(text.str());
      }
    if (!(poissons_ratio > -1. && poissons_ratio < 0.5))
      {
        text << path << "/Poisson's ratio is " << poissons_ratio
             << ", but has to be greater than -1 and less than 0.5.";
        throw UserError(text.str());
      }
  }



  double
  ElasticConstants::lame_lambda() const
  {
    return youngs_modulus * poissons_ratio /
           ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
  }



  double
  ElasticConstants::bulk_modulus() const
  {
    return youngs_modulus / (3. * (1. - 2. * poissons_ratio));
  }



  double
  ElasticConstants::shear_modulus() const
  {
    return youngs_modulus / (2. * (1. + poissons_ratio));
  }
} // namespace stickslip
