#ifndef stickslip_tests_unit_mixed_hardening_h
#define stickslip_tests_unit_mixed_hardening_h

// The laws of the tests with back stresses.

#include "law_at_a_point.h"

#include <stickslip/solid/hencky.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace law_test
{
  using BackStresses = std::vector<std::pair<double, double>>;

  /// The hardenings of the tests; moduli over a yield stress of 0.1.
  struct Hardening
  {
    std::string  name;
    double       modulus;
    BackStresses recovered;
  };

  const std::vector<Hardening> hardenings = {
    {"Prager", 0.1, {}},
    {"Armstrong-Frederick", 0., {{0.5, 5.}}},
    {"Chaboche", 0.05, {{2., 40.}, {0.5, 5.}, {0.1, 1.}}}};



  /// E = 1, nu = 0.3, yield stress 0.1, linear isotropic hardening.
  template <typename Law>
  std::shared_ptr<Law>
  plastic_law(const Hardening &kinematic)
  {
    const auto law                = std::make_shared<Law>();
    law->constants.youngs_modulus = 1.;
    law->constants.poissons_ratio = 0.3;
    law->hardening.type           = HardeningType::linear;
    law->hardening.yield_stress   = 0.1;
    law->hardening.modulus        = 0.02;
    law->kinematic.modulus        = kinematic.modulus;
    law->kinematic.recovered      = kinematic.recovered;
    law->check("law");
    return law;
  }



  struct NamedLaw
  {
    std::string                      name;
    std::shared_ptr<ConstitutiveLaw> law;
  };



  /// All laws with all back stresses.
  inline std::vector<NamedLaw>
  all_laws()
  {
    std::vector<NamedLaw> laws;
    for (const Hardening &kinematic : hardenings)
      {
        const auto rotating = plastic_law<SmallStrainPlasticity>(kinematic);
        rotating->strain_measure = StrainMeasure::green_lagrange;
        laws.push_back({"Hencky, " + kinematic.name,
                        plastic_law<HenckyPlasticity>(kinematic)});
        laws.push_back({"Green-Lagrange, " + kinematic.name, rotating});
        laws.push_back({"small strain, " + kinematic.name,
                        plastic_law<SmallStrainPlasticity>(kinematic)});
      }
    return laws;
  }
} // namespace law_test

#endif
