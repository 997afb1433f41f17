#include <stickslip/solid/kinematic_hardening.h>

#include <stickslip/base/choice.h>
#include <stickslip/base/user_error.h>

#include <stickslip/solid/history_tensor.h>

#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    const Choices<KinematicModulusType> &
    all_kinematic_modulus_types()
    {
      static const Choices<KinematicModulusType> choices = {
        {"slope", KinematicModulusType::slope},
        {"Prager constant", KinematicModulusType::prager_constant}};
      return choices;
    }
  } // namespace



  BackStress::Evolution
  BackStress::evolution(const double dp) const
  {
    const double x      = recovery * dp;
    const double kept   = std::exp(-x);
    const double gained = x == 0. ? 1. : -std::expm1(-x) / x;
    // The series where the difference would cancel.
    const double gained_slope =
      x < 1e-3 ? recovery * (-0.5 + x / 3. - x * x / 8. + x * x * x / 30.)
               : (kept - gained) / dp;
    return {kept, gained, -recovery * kept, gained_slope};
  }



  void
  KinematicHardening::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Kinematic modulus",
                      modulus,
                      "Of Prager's linear kinematic hardening, force per area. "
                      "'Kinematic modulus is' says which slope it is.",
                      dealii::Patterns::Double());
    add_choice(prm,
               "Kinematic modulus is",
               modulus_type,
               all_kinematic_modulus_types(),
               "slope: of the uniaxial back stress over the plastic "
               "strain, so that X = 2/3 C e_p. Prager constant: C of the back "
               "stress tensor X = C e_p, which has the uniaxial slope 3/2 C. "
               "Also of the C in 'Back stresses'.");
    prm.add_parameter(
      "Back stresses",
      recovered,
      "Points 'C : gamma', separated by commas: back stresses with recovery "
      "(Armstrong-Frederick; several: Chaboche), dX = 2/3 C de_p - gamma X dp, "
      "beside the linear one. In a uniaxial test each begins with the slope C "
      "over the plastic strain and ends at the stress C/gamma.",
      *dealii::Patterns::Tools::Convert<decltype(recovered)>::to_pattern());
  }



  void
  KinematicHardening::check(const std::string &path) const
  {
    if (!(modulus >= 0.))
      {
        std::ostringstream text;
        text << path << "/Kinematic modulus is " << modulus
             << ", but has to be at least 0.";
        throw UserError(text.str());
      }
    const std::string name = path + "/Back stresses";
    if (recovered.size() > max_back_stresses)
      throw UserError(name + " has " + std::to_string(recovered.size()) +
                      " members, but at most " +
                      std::to_string(max_back_stresses) + " are allowed.");
    for (const auto &[C, gamma] : recovered)
      if (!(C > 0. && std::isfinite(C)) ||
          !(gamma > 0. && std::isfinite(gamma)))
        {
          std::ostringstream text;
          text << name << ": C and gamma have to be greater than 0, but there "
               << "is " << C << " : " << gamma
               << ". (Without recovery: 'Kinematic modulus'.)";
          throw UserError(text.str());
        }
  }



  bool
  KinematicHardening::is_active() const
  {
    return modulus > 0. || !recovered.empty();
  }



  double
  KinematicHardening::uniaxial(const double given) const
  {
    return modulus_type == KinematicModulusType::slope ? given : 1.5 * given;
  }



  BackStress
  KinematicHardening::term(const unsigned int k) const
  {
    if (k == 0)
      return {slope(), 0.};
    return {uniaxial(recovered[k - 1].first), recovered[k - 1].second};
  }



  double
  KinematicHardening::slope() const
  {
    return uniaxial(modulus);
  }



  double
  KinematicHardening::uniaxial_stress(const double p) const
  {
    double stress = 0.;
    for (unsigned int k = 0; k < n_terms(); ++k)
      stress += term(k).modulus * term(k).evolution(p).gained * p;
    return stress;
  }



  void
  KinematicHardening::append_history_names(
    std::vector<std::string> &names) const
  {
    for (unsigned int k = 1; k < n_terms(); ++k)
      append_tensor_names("back_stress_" + std::to_string(k), names);
  }



  void
  KinematicHardening::read_back_strains(
    const dealii::ArrayView<const double> &history,
    const unsigned int                     first,
    BackStrains                           &strains) const
  {
    for (unsigned int k = 1; k < n_terms(); ++k)
      strains[k] =
        read_tensor(history, first + 6 * (k - 1)) * 1.5 / term(k).modulus;
  }



  void
  KinematicHardening::write_back_stresses(
    const BackStrains               &strains,
    const dealii::ArrayView<double> &history,
    const unsigned int               first) const
  {
    for (unsigned int k = 1; k < n_terms(); ++k)
      write_tensor(2. / 3. * term(k).modulus * strains[k],
                   history,
                   first + 6 * (k - 1));
  }
} // namespace stickslip
