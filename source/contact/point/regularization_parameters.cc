#include <stickslip/contact/point/regularization_parameters.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/utilities.h>

namespace stickslip
{
  namespace
  {
    /// What @p text says; @p value for @p word.
    double
    number_or(const std::string &text,
              const std::string &word,
              const double       value)
    {
      return text == word ? value : Utilities::string_to_double(text);
    }



    void
    check_number_or(const std::string &text,
                    const std::string &word,
                    const std::string &path)
    {
      double value = 0.;
      try
        {
          value = number_or(text, word, 1.);
        }
      catch (...)
        {
          throw UserError("'" + path + " = " + text +
                          "': expected a number or '" + word + "'.");
        }
      if (!(value > 0.))
        throw UserError("'" + path + " = " + text +
                        "': must be larger than 0.");
    }
  } // namespace



  const Choices<RegularizationScale> &
  all_regularization_scales()
  {
    static const Choices<RegularizationScale> choices = {
      {"automatic", RegularizationScale::automatic},
      {"bound", RegularizationScale::bound},
      {"plain", RegularizationScale::plain}};
    return choices;
  }



  void
  RegularizationParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Scale",
      scale,
      all_regularization_scales(),
      expert(
        "automatic: r_n and r_t are dimensionless factors. At each contact "
        "point "
        "r_n multiplies k = 1/(h_s/M_s + h_m/M_m), with h the height of the "
        "slave "
        "and master cell and M their longitudinal moduli, and r_t multiplies "
        "k/(mu p), with p the pressure there. bound: r_n multiplies 100 M and "
        "r_t multiplies 10 mu M (mu = 1 for Tresca), with M the smallest "
        "modulus "
        "of the pair: the upper bounds of the paper (eq. 27) as printed, "
        "numbers "
        "that depend on the units of the case. plain: r_n is a number in "
        "stress/length and r_t in 1/length."));
    prm.add_parameter(
      "r_n",
      r_n,
      expert(
        "Normal regularization parameter of the three roles (status, "
        "augmentation, "
        "law) that have no number of their own: a number or, unless 'Scale = "
        "plain', automatic. That is 1 with 'Scale = bound' and for nodal, 0.03 "
        "for segments (the answer does not depend on it with these two), and "
        "0.01 for rules with more points than multipliers (the answer drifts "
        "with it)."));
    prm.add_parameter(
      "r_t",
      r_t,
      expert(
        "Tangential regularization parameter of the three roles that have no "
        "number of their own: a number or, unless 'Scale = plain', automatic. "
        "That is 1 with 'Scale = bound' and for nodal, 0.1 for segments, and "
        "0.25 for other rules (the answer drifts with it there)."));
    prm.add_parameter("r_n status",
                      r_n_status,
                      expert(
                        "r_n in the contact status S_c(lambda_n - r_n d_n): a "
                        "number or r_n."));
    prm.add_parameter(
      "r_n augmentation",
      r_n_augmentation,
      expert("r_n in the contact force lambda_n - r_n d_n: a number "
             "or r_n. With a value other than that of the status the "
             "force jumps where the status changes; only for nodal "
             "quadrature is that harmless."));
    prm.add_parameter("r_n law",
                      r_n_law,
                      expert(
                        "r_n in the weak Signorini condition (scales its rows "
                        "for open points): a number or r_n."));
    prm.add_parameter(
      "r_t status",
      r_t_status,
      expert("r_t in the slip status S_f(Lambda + r_t d_t): a number "
             "or r_t. Not above twice 'r_t law': points that slip "
             "against their traction would then satisfy the discrete "
             "equations. With nodal quadrature, where every point of "
             "a converged state is checked, that is a warning only."));
    prm.add_parameter(
      "r_t augmentation",
      r_t_augmentation,
      expert("r_t in the friction force Lambda + r_t d_t: a number or "
             "r_t."));
    prm.add_parameter("r_t law",
                      r_t_law,
                      expert(
                        "r_t in the weak Coulomb condition: a number or r_t."));
  }



  DefaultFactors
  default_factors(const ContactRule rule)
  {
    // One multiplier per point: the answer does not depend on them. Segments
    // take the fewest iterations with small ones, which turn no slip that is
    // wrong into one the other way; nodal with r_t from 1 to 2 where surfaces
    // slide. Other rules: small, because the answer drifts with r.
    if (rule == ContactRule::segments)
      return {0.03, 0.1};
    if (has_one_multiplier_per_point(rule))
      return {1., 1.};
    return {0.01, 0.25};
  }



  RegularizationFactors
  RegularizationParameters::factors(const ContactRule rule) const
  {
    const DefaultFactors automatic = scale == RegularizationScale::automatic
                                       ? default_factors(rule)
                                       : DefaultFactors();
    const double         n         = number_or(r_n, "automatic", automatic.r_n);
    const double         t         = number_or(r_t, "automatic", automatic.r_t);
    return {number_or(r_n_status, "r_n", n),
            number_or(r_n_augmentation, "r_n", n),
            number_or(r_n_law, "r_n", n),
            number_or(r_t_status, "r_t", t),
            number_or(r_t_augmentation, "r_t", t),
            number_or(r_t_law, "r_t", t)};
  }



  void
  RegularizationParameters::check(const std::string &path,
                                  const ContactRule  rule) const
  {
    if (scale == RegularizationScale::plain &&
        (r_n == "automatic" || r_t == "automatic"))
      throw UserError("'" + path +
                      "': with 'Scale = plain' both 'r_n' and 'r_t' must be "
                      "numbers.");
    check_number_or(r_n, "automatic", path + "/r_n");
    check_number_or(r_t, "automatic", path + "/r_t");
    check_number_or(r_n_status, "r_n", path + "/r_n status");
    check_number_or(r_n_augmentation, "r_n", path + "/r_n augmentation");
    check_number_or(r_n_law, "r_n", path + "/r_n law");
    check_number_or(r_t_status, "r_t", path + "/r_t status");
    check_number_or(r_t_augmentation, "r_t", path + "/r_t augmentation");
    check_number_or(r_t_law, "r_t", path + "/r_t law");
    const RegularizationFactors given = factors(rule);
    if (given.status_over_law() > 2. && !has_one_multiplier_per_point(rule))
      throw UserError(
        "'" + path + "/r_t status' = " + std::to_string(given.r_t_status) +
        " is more than twice 'r_t law' = " + std::to_string(given.r_t_law) +
        ": points that slip against their traction would then "
        "satisfy the discrete equations. Lower it, or take 'Quadrature = "
        "nodal', where every point is checked.");
  }
} // namespace stickslip
