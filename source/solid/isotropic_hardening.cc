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



    const Choices<TableOrdinate> &
    all_table_ordinates()
    {
      static const Choices<TableOrdinate> choices = {
        {"yield stress", TableOrdinate::yield_stress},
        {"uniaxial stress", TableOrdinate::uniaxial_stress}};
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
      "Prager's kinematic hardening included; then H = E E_T/(E - E_T) less "
      "the kinematic slope. (Back stresses with recovery are not: E_T is the "
      "slope that the curve has when these have ended.)");
    prm.add_parameter(
      "Hardening table",
      table,
      "Points 'strain : stress', separated by commas, of the uniaxial curve; "
      "the first is the first yield, and beyond the last one the curve goes on "
      "with its last slope. Stresses must not fall.",
      *dealii::Patterns::Tools::Convert<decltype(table)>::to_pattern());
    prm.add_parameter("Hardening table file",
                      table_file,
                      "The table as a file of numbers (CSV or columns), a line "
                      "per point, instead of 'Hardening table'; a first line "
                      "of names and lines that begin with # are left out. "
                      "Relative names start at the folder of the .prm file.",
                      Anything());
    prm.add_parameter("Hardening table columns",
                      table_columns,
                      "The file's columns of strain and stress, counted from "
                      "1.",
                      List(Integer(1, 1000), 2, 2));
    add_choice(prm,
               "Hardening table abscissa",
               table_abscissa,
               all_table_abscissae(),
               "plastic strain: p, beginning with 0. total strain: "
               "p + stress/E, as in a measured curve.");
    add_choice(prm,
               "Hardening table ordinate",
               table_ordinate,
               all_table_ordinates(),
               "yield stress: R. uniaxial stress: R and the kinematic "
               "hardening together, as in a measured curve; R is then the "
               "stress less the uniaxial back stress. The same without "
               "kinematic hardening.");
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
  IsotropicHardening::read_table_file(const std::string &path,
                                      const std::string &directory,
                                      const MPI_Comm     communicator)
  {
    if (table_file.empty() || type != HardeningType::tabulated)
      return;
    if (!table.empty())
      throw UserError(path +
                      ": give either 'Hardening table' or 'Hardening "
                      "table file', not both.");
    table = read_number_table(table_file,
                              directory,
                              table_columns,
                              path + "/Hardening table file",
                              communicator);
  }



  void
  IsotropicHardening::check(const std::string        &path,
                            const ElasticConstants   &elastic,
                            const KinematicHardening &kinematic) const
  {
    if (type == HardeningType::tabulated)
      {
        check_table(path, elastic.youngs_modulus, kinematic);
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
        const double slope = linear_slope(elastic, kinematic);
        if (!(slope >= -1e-12 * elastic.youngs_modulus))
          {
            std::ostringstream rule;
            rule << "larger: kinematic hardening alone has the slope "
                 << kinematic.slope()
                 << " over the plastic strain, which leaves " << slope
                 << " for the isotropic one";
            refuse(path, "Hardening modulus", modulus, rule.str());
          }
      }
  }



  void
  IsotropicHardening::check_table(const std::string        &path,
                                  const double              youngs_modulus,
                                  const KinematicHardening &kinematic) const
  {
    const std::string name =
      path +
      (table_file.empty() ? "/Hardening table" : "/Hardening table file");
    if (table.empty())
      throw UserError(name + " is empty, but 'Hardening' is tabulated.");
    const auto refuse_points = [&](const std::string &rule) {
      throw UserError(name + ": " + rule);
    };
    if (!(table.front().second > 0.))
      refuse_points("the first stress has to be greater than 0.");
    // A measured curve rarely begins exactly on the elastic line.
    const double tolerance = table_abscissa == TableAbscissa::total_strain
                               ? 1e-3 * table.front().second / youngs_modulus
                               : 0.;
    const double first     = plastic_strain(0, youngs_modulus);
    if (!(std::abs(first) <= tolerance))
      {
        std::ostringstream text;
        text << "the plastic strain of the first point is " << first
             << ", but has to be 0, because it is the first yield.";
        refuse_points(text.str());
      }
    for (unsigned int i = 1; i < table.size(); ++i)
      {
        std::ostringstream place;
        place << table[i].first << " : " << table[i].second << " follows "
              << table[i - 1].first << " : " << table[i - 1].second;
        if (!(plastic_strain(i, youngs_modulus) >
              plastic_strain(i - 1, youngs_modulus)) ||
            !(table[i].second >= table[i - 1].second))
          refuse_points(
            "plastic strains have to grow and stresses must not "
            "fall, but " +
            place.str() + ".");
        const double before =
          table_yield_stress(i - 1, youngs_modulus, kinematic);
        const double after = table_yield_stress(i, youngs_modulus, kinematic);
        if (!(after >= before))
          {
            std::ostringstream text;
            text << "the kinematic hardening alone rises more than the curve "
                 << "where " << place.str() << ": the yield stress would fall "
                 << "from " << before << " to " << after << ".";
            refuse_points(text.str());
          }
      }
  }



  double
  IsotropicHardening::linear_slope(const ElasticConstants   &elastic,
                                   const KinematicHardening &kinematic) const
  {
    if (modulus_type == HardeningModulusType::slope)
      return modulus;
    const double E = elastic.youngs_modulus;
    return E * modulus / (E - modulus) - kinematic.slope();
  }



  IsotropicHardening::YieldStress
  IsotropicHardening::at(const double              p,
                         const ElasticConstants   &elastic,
                         const KinematicHardening &kinematic) const
  {
    if (type == HardeningType::none)
      return {yield_stress, 0.};
    if (type == HardeningType::linear)
      {
        const double H = linear_slope(elastic, kinematic);
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
        const double H = linear_slope(elastic, kinematic);
        const double decay =
          (saturation - yield_stress) * std::exp(-p / reference_strain);
        return {saturation - decay + H * p, decay / reference_strain + H};
      }
    return interpolate(p, elastic.youngs_modulus, kinematic);
  }



  double
  IsotropicHardening::plastic_strain(const unsigned int point,
                                     const double       youngs_modulus) const
  {
    const auto [strain, stress] = table[point];
    return table_abscissa == TableAbscissa::total_strain
             ? strain - stress / youngs_modulus
             : strain;
  }



  double
  IsotropicHardening::table_yield_stress(
    const unsigned int        point,
    const double              youngs_modulus,
    const KinematicHardening &kinematic) const
  {
    const double stress = table[point].second;
    return table_ordinate == TableOrdinate::uniaxial_stress
             ? stress - kinematic.uniaxial_stress(
                          plastic_strain(point, youngs_modulus))
             : stress;
  }



  IsotropicHardening::YieldStress
  IsotropicHardening::interpolate(const double              p,
                                  const double              youngs_modulus,
                                  const KinematicHardening &kinematic) const
  {
    if (table.size() == 1)
      return {table[0].second, 0.};
    // The first point beyond p, or the last one, by halving: measured curves
    // have many points.
    unsigned int start = 0, end = table.size() - 1;
    while (end - start > 1)
      {
        const unsigned int middle = (start + end) / 2;
        (plastic_strain(middle, youngs_modulus) <= p ? start : end) = middle;
      }
    const double first  = plastic_strain(start, youngs_modulus);
    const double stress = table_yield_stress(start, youngs_modulus, kinematic);
    const double slope =
      (table_yield_stress(end, youngs_modulus, kinematic) - stress) /
      (plastic_strain(end, youngs_modulus) - first);
    return {stress + slope * (p - first), slope};
  }
} // namespace stickslip
