#include <stickslip/solid/isotropic_hardening.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Throws UserError "PATH/NAME is VALUE, but has to be RULE."
    void
    refuse(const std::string &path,
           const std::string &name,
           const double       value,
           const std::string &rule)
    {
      std::ostringstream text;
      text << path << "/" << name << " is " << value << ", but has to be "
           << rule << ".";
      throw UserError(text.str());
    }



    const Choices<HardeningModulusType> &
    all_hardening_modulus_types()
    {
      static const Choices<HardeningModulusType> choices = {
        {"slope", HardeningModulusType::slope},
        {"tangent modulus", HardeningModulusType::tangent_modulus}};
      return choices;
    }



    const Choices<TableAbscissa> &
    all_table_abscissae()
    {
      static const Choices<TableAbscissa> choices = {
        {"plastic strain", TableAbscissa::plastic_strain},
        {"total strain", TableAbscissa::total_strain}};
      return choices;
    }
  } // namespace



  const Choices<HardeningType> &
  all_hardening_types()
  {
    static const Choices<HardeningType> choices = {
      {"none", HardeningType::none},
      {"linear", HardeningType::linear},
      {"tabulated", HardeningType::tabulated},
      {"power", HardeningType::power},
      {"Voce", HardeningType::voce}};
    return choices;
  }



  void
  IsotropicHardening::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.add_parameter("Yield stress",
                      yield_stress,
                      "sy, at the first yield in a uniaxial test; force per "
                      "area. Unused with a table.",
                      Double());
    add_choice(
      prm,
      "Hardening",
      type,
      all_hardening_types(),
      "The yield stress R as a function of the equivalent plastic strain p. "
      "none: R = sy. linear: R = sy + H p. tabulated: linear between the "
      "points of 'Hardening table'. power: R = sy (1 + p/p0)^n. Voce: "
      "R = sy + (s_inf - sy)(1 - exp(-p/p0)) + H p.");
    prm.add_parameter("Hardening modulus",
                      modulus,
                      "H of linear and Voce; force per area. 'Hardening "
                      "modulus is' says which slope it is.",
                      Double());
    add_choice(
      prm,
      "Hardening modulus is",
      modulus_type,
      all_hardening_modulus_types(),
      "slope: dR/dp, over the plastic strain. tangent modulus: E_T, the slope "
      "of the whole uniaxial stress-strain curve over the total strain, "
      "kinematic "
      "hardening included; then H = E E_T/(E - E_T) less the kinematic slope.");
    prm.add_parameter(
      "Hardening table",
      table,
      "Points 'strain : stress', separated by commas, of the uniaxial curve; "
      "the first is the first yield, and beyond the last one the curve goes on "
      "with its last slope. Stresses must not fall.",
      *dealii::Patterns::Tools::Convert<decltype(table)>::to_pattern());
    add_choice(prm,
               "Hardening table abscissa",
               table_abscissa,
               all_table_abscissae(),
               "plastic strain: p, beginning with 0. total strain: "
               "p + stress/E, as in a measured curve.");
    prm.add_parameter("Reference plastic strain",
                      reference_strain,
                      "p0 of power and Voce; without unit.",
                      Double());
    prm.add_parameter("Hardening exponent",
                      exponent,
                      "n of power, from 0 to 1.",
                      Double());
    prm.add_parameter("Saturation stress",
                      saturation,
                      "s_inf of Voce; force per area.",
                      Double());
  }



  void
  IsotropicHardening::check(const std::string      &path,
                            const ElasticConstants &elastic,
                            const double            kinematic_slope) const
  {
    if (type == HardeningType::tabulated)
      {
        check_table(path, elastic.youngs_modulus);
        return;
      }
    if (!(yield_stress > 0.))
      refuse(path, "Yield stress", yield_stress, "greater than 0");
    if ((type == HardeningType::power || type == HardeningType::voce) &&
        !(reference_strain > 0.))
      refuse(path,
             "Reference plastic strain",
             reference_strain,
             "greater than 0");
    if (type == HardeningType::power && !(exponent >= 0. && exponent <= 1.))
      refuse(path, "Hardening exponent", exponent, "between 0 and 1");
    if (type == HardeningType::voce && !(saturation >= yield_stress))
      refuse(path,
             "Saturation stress",
             saturation,
             "at least the yield stress");
    if (type != HardeningType::linear && type != HardeningType::voce)
      return;
    if (modulus_type == HardeningModulusType::slope && !(modulus >= 0.))
      refuse(path, "Hardening modulus", modulus, "at least 0");
    if (modulus_type == HardeningModulusType::tangent_modulus)
      {
        if (!(modulus < elastic.youngs_modulus))
          refuse(path,
                 "Hardening modulus",
                 modulus,
                 "less than Young's modulus, because it is a tangent modulus");
        const double slope = linear_slope(elastic, kinematic_slope);
        if (!(slope >= -1e-12 * elastic.youngs_modulus))
          {
            std::ostringstream rule;
            rule << "larger: kinematic hardening alone has the slope "
                 << kinematic_slope << " over the plastic strain, which leaves "
                 << slope << " for the isotropic one";
            refuse(path, "Hardening modulus", modulus, rule.str());
          }
      }
  }



  void
  IsotropicHardening::check_table(const std::string &path,
                                  const double       youngs_modulus) const
  {
    const std::string name = path + "/Hardening table";
    if (table.empty())
      throw UserError(name + " is empty, but 'Hardening' is tabulated.");
    const bool total          = table_abscissa == TableAbscissa::total_strain;
    const auto plastic_strain = [&](const std::pair<double, double> &point) {
      return total ? point.first - point.second / youngs_modulus : point.first;
    };
    if (!(table.front().second > 0.))
      throw UserError(name + ": the first stress has to be greater than 0.");
    // A measured curve rarely begins exactly on the elastic line.
    const double tolerance =
      total ? 1e-3 * table.front().second / youngs_modulus : 0.;
    if (!(std::abs(plastic_strain(table.front())) <= tolerance))
      {
        std::ostringstream text;
        text << name << ": the plastic strain of the first point is "
             << plastic_strain(table.front())
             << ", but has to be 0, because it is the first yield.";
        throw UserError(text.str());
      }
    for (unsigned int i = 1; i < table.size(); ++i)
      if (!(plastic_strain(table[i]) > plastic_strain(table[i - 1])) ||
          !(table[i].second >= table[i - 1].second))
        {
          std::ostringstream text;
          text << name << ": plastic strains have to grow and stresses must "
               << "not fall, but " << table[i].first << " : " << table[i].second
               << " follows " << table[i - 1].first << " : "
               << table[i - 1].second << ".";
          throw UserError(text.str());
        }
  }



  double
  IsotropicHardening::linear_slope(const ElasticConstants &elastic,
                                   const double kinematic_slope) const
  {
    if (modulus_type == HardeningModulusType::slope)
      return modulus;
    const double E = elastic.youngs_modulus;
    return E * modulus / (E - modulus) - kinematic_slope;
  }



  IsotropicHardening::YieldStress
  IsotropicHardening::at(const double            p,
                         const ElasticConstants &elastic,
                         const double            kinematic_slope) const
  {
    if (type == HardeningType::none)
      return {yield_stress, 0.};
    if (type == HardeningType::linear)
      {
        const double H = linear_slope(elastic, kinematic_slope);
        return {yield_stress + H * p, H};
      }
    if (type == HardeningType::power)
      {
        const double base  = 1. + p / reference_strain;
        const double value = yield_stress * std::pow(base, exponent);
        return {value, exponent * value / (base * reference_strain)};
      }
    if (type == HardeningType::voce)
      {
        const double H = linear_slope(elastic, kinematic_slope);
        const double decay =
          (saturation - yield_stress) * std::exp(-p / reference_strain);
        return {saturation - decay + H * p, decay / reference_strain + H};
      }
    return interpolate(p, elastic.youngs_modulus);
  }



  IsotropicHardening::YieldStress
  IsotropicHardening::interpolate(const double p,
                                  const double youngs_modulus) const
  {
    if (table.size() == 1)
      return {table[0].second, 0.};
    const bool total          = table_abscissa == TableAbscissa::total_strain;
    const auto plastic_strain = [&](const std::pair<double, double> &point) {
      return total ? point.first - point.second / youngs_modulus : point.first;
    };
    unsigned int end = 1;
    while (end + 1 < table.size() && plastic_strain(table[end]) <= p)
      ++end;
    const double first = plastic_strain(table[end - 1]);
    const double slope = (table[end].second - table[end - 1].second) /
                         (plastic_strain(table[end]) - first);
    return {table[end - 1].second + slope * (p - first), slope};
  }
} // namespace stickslip
