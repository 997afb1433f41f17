#include <stickslip/contact/point/contact_parameters.h>

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



  const Choices<Friction> &
  all_frictions()
  {
    static const Choices<Friction> choices = {{"none", Friction::none},
                                              {"Coulomb", Friction::Coulomb},
                                              {"Tresca", Friction::Tresca}};
    return choices;
  }



  const Choices<ThresholdForm> &
  all_threshold_forms()
  {
    static const Choices<ThresholdForm> choices = {
      {"augmented", ThresholdForm::augmented}, {"plain", ThresholdForm::plain}};
    return choices;
  }



  const Choices<MultiplierSpace> &
  all_multiplier_spaces()
  {
    static const Choices<MultiplierSpace> choices = {
      {"automatic", MultiplierSpace::automatic},
      {"displacement trace", MultiplierSpace::displacement_trace},
      {"vertices", MultiplierSpace::vertices}};
    return choices;
  }



  const Choices<Normals> &
  all_normals()
  {
    static const Choices<Normals> choices = {{"facet", Normals::facet},
                                             {"smoothed", Normals::smoothed}};
    return choices;
  }



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
        "plain', automatic. That is 1 with 'Scale = bound' and where the "
        "contact "
        "points are the multiplier nodes (the answer does not depend on it "
        "there), and 0.01 for rules with more points than multipliers (the "
        "answer drifts with it)."));
    prm.add_parameter(
      "r_t",
      r_t,
      expert(
        "Tangential regularization parameter of the three roles that have no "
        "number of their own: a number or, unless 'Scale = plain', automatic. "
        "That is 1 with 'Scale = bound' and where the contact points are the "
        "multiplier nodes, and 0.25 for other rules (the answer drifts with it "
        "there)."));
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



  RegularizationFactors
  RegularizationParameters::factors(const ContactRule rule) const
  {
    // Nodal: GNM takes the fewest iterations with r_t from 1 to 2 where
    // surfaces slide, and cuts steps with 0.25 and 0.5. Other rules: smaller,
    // because the answer drifts with r.
    const bool drifts = scale == RegularizationScale::automatic &&
                        !has_one_multiplier_per_point(rule);
    const double n = number_or(r_n, "automatic", drifts ? 0.01 : 1.);
    const double t = number_or(r_t, "automatic", drifts ? 0.25 : 1.);
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



  void
  ContactPairParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Slave body",
                      slave_body,
                      "Body whose surface carries the contact points and the "
                      "multipliers. Prefer the softer or finer one.");
    prm.add_parameter("Slave boundary",
                      slave_boundary,
                      "Boundary ids or names of the slave body.");
    prm.add_parameter("Master body", master_body, "Body that is projected on.");
    prm.add_parameter("Master boundary",
                      master_boundary,
                      "Boundary ids or names of the master body.");
    add_choice(prm,
               "Friction",
               friction,
               all_frictions(),
               "none, Coulomb (threshold mu times the pressure) or "
               "Tresca (given threshold).");
    prm.add_parameter("Friction coefficient",
                      friction_coefficient,
                      "Coulomb's mu.",
                      Patterns::Double(0.));
    prm.add_parameter("Tresca threshold",
                      tresca_threshold,
                      "Largest tangential traction [stress] for Tresca.",
                      Patterns::Double(0.));
    add_choice(
      prm,
      "Threshold",
      threshold_form,
      all_threshold_forms(),
      expert(
        "Friction threshold while it is live: augmented is "
        "-mu (lambda_n - r_n d_n), never negative at a closed point; plain is "
        "the "
        "paper's -mu lambda_n. Both are the same at the solution."));
    add_choice(prm,
               "Multiplier space",
               multiplier_space,
               all_multiplier_spaces(),
               expert("Multipliers on the slave faces: of the degree of the "
                      "displacement, or linear with nodes at the vertices (the "
                      "P2-P1 element if the displacement degree is 2). "
                      "automatic: vertices on tetrahedra of degree 2, whose "
                      "faces have nodal weights of zero at the vertices, and "
                      "the displacement trace on all other cells."));
    add_choice(prm,
               "Quadrature",
               quadrature,
               all_contact_rules(),
               "Rule that places the contact points on a slave face.");
    prm.add_parameter(
      "Quadrature order",
      quadrature_order,
      "Gauss: points per direction. Simpson: subintervals. "
      "Newton-Cotes: intervals. segments: points per direction "
      "of a segment, if more than parallelograms need. Not used "
      "by nodal.",
      Patterns::Integer(1, 20));
    add_choice(prm,
               "Weighting functions",
               weighting,
               all_weighting_functions(),
               expert(
                 "With 'Quadrature = segments': what gap and slip are averaged "
                 "with, the multipliers' shape functions or the functions dual "
                 "(biorthogonal) to them."));
    add_choice(prm,
               "Normals",
               normals,
               all_normals(),
               "smoothed: interpolated from nodal averages, continuous across "
               "facets. facet: the master facet's own normal, as in the "
               "paper; it jumps from facet to facet, so that sliding over a "
               "curved surface without friction still takes work.");
    prm.add_parameter(
      "Smoothing angle",
      smoothing_angle,
      expert("Facets whose reference normals differ by more than this "
             "angle [degrees] are not averaged (sharp edges stay "
             "sharp)."),
      Patterns::Double(0., 180.));
    prm.add_parameter("Search distance",
                      search_distance,
                      "Slave points farther than this from the master are not "
                      "paired [length]. 0: four times the largest slave face.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Projection tolerance",
      projection_tolerance,
      expert(
        "How far beyond the end of the master surface, as a fraction of the "
        "face "
        "size, a slave point may lie sideways to be paired with it; 0.8 times "
        "its distance from the master is added (so 5 times this in all for a "
        "point level with the surface)."),
      Patterns::Double(0.));
    prm.add_parameter(
      "Facet overlap",
      facet_overlap,
      expert(
        "Only where a load step has failed and is tried again: a point that "
        "then "
        "changes its master facet six times keeps it until its projection is "
        "this fraction of the facet outside (10 times as much after twelve "
        "changes, 50 times after eighteen, 0.5 at most), also in later steps "
        "while it is outside. Points at a kink between facets then do not "
        "switch indefinitely. 0: never."),
      Patterns::Double(0., 0.2));
    prm.add_parameter(
      "End overlap",
      end_overlap,
      expert(
        "Likewise, a point at the end of the master surface that loses or "
        "finds "
        "its partner four times keeps it until it is this fraction of the face "
        "beyond the end. 0: never."),
      Patterns::Double(0., 2.));
    prm.add_parameter("Gap offset",
                      gap_offset,
                      "Function of x, y, z, t added to the gap [length]: a "
                      "positive value opens it.");
    initial_gaps.add_parameters(prm);
    prm.add_parameter("Excluded boundaries",
                      excluded_boundaries,
                      "Nodes on these boundaries (ids or names) of the slave "
                      "body carry no contact.");
    prm.add_parameter("Excluded points",
                      excluded_points,
                      "Nodes at these reference positions carry no contact: "
                      "'x,y; x,y; ...'.");
    prm.enter_subsection("Regularization");
    regularization.add_parameters(prm);
    prm.leave_subsection();
  }



  void
  ContactPairParameters::check(const std::string &path) const
  {
    const auto require = [&](const bool ok, const std::string &name) {
      if (!ok)
        throw UserError("'" + path + "/" + name +
                        "' is missing: a contact pair needs Slave body, Slave "
                        "boundary, Master body and Master boundary.");
    };
    require(!slave_body.empty(), "Slave body");
    require(!slave_boundary.empty(), "Slave boundary");
    require(!master_body.empty(), "Master body");
    require(!master_boundary.empty(), "Master boundary");
    if (friction != Friction::Coulomb && friction_coefficient > 0.)
      throw UserError("'" + path +
                      "/Friction coefficient' is given, but 'Friction = " +
                      name_of(friction, all_frictions()) +
                      "'. Set 'Friction = Coulomb' or remove it.");
    if (friction == Friction::Coulomb && !(friction_coefficient > 0.))
      throw UserError("'" + path +
                      "/Friction coefficient' must be larger than 0 with "
                      "'Friction = Coulomb'. For frictionless contact set "
                      "'Friction = none'.");
    if (friction == Friction::Tresca && !(tresca_threshold > 0.))
      throw UserError("'" + path +
                      "/Tresca threshold' must be larger than 0 with 'Friction "
                      "= Tresca'.");
    initial_gaps.check(path);
    regularization.check(path + "/Regularization", quadrature);
  }
} // namespace stickslip
