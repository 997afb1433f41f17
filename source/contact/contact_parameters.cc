#include <stickslip/base/user_error.h>

#include <stickslip/contact/contact_parameters.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// The number that @p text is; NaN for a word among @p allowed words.
    double
    number_or_word(const std::string              &text,
                   const std::vector<std::string> &allowed,
                   const std::string              &path)
    {
      for (const std::string &word : allowed)
        if (text == word)
          return std::numeric_limits<double>::quiet_NaN();
      double value = 0.;
      try
        {
          value = Utilities::string_to_double(text);
        }
      catch (...)
        {
          throw UserError("'" + path + " = " + text +
                          "': expected a number or '" + allowed[0] + "'.");
        }
      if (!(value > 0.))
        throw UserError("'" + path + " = " + text +
                        "': must be larger than 0.");
      return value;
    }



  } // namespace



  void
  RegularizationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Scale",
      scale,
      "automatic: r_n and r_t are dimensionless factors. At each contact point "
      "r_n multiplies k = 1/(h_s/M_s + h_m/M_m), with h the height of the "
      "slave "
      "and master cell and M their longitudinal moduli, and r_t multiplies "
      "k/(mu p), with p the pressure there. plain: r_n is a number in "
      "stress/length and r_t in 1/length.",
      Patterns::Selection("automatic|plain"));
    prm.add_parameter(
      "r_n",
      r_n,
      "Normal regularization parameter of the three roles (status, "
      "augmentation, "
      "law) that have no number of their own: a number, or with 'Scale = "
      "automatic' also automatic, which is 1 where the contact points are the "
      "multiplier nodes (the answer does not depend on it there) and 0.01 for "
      "rules with more points than multipliers (the answer drifts with it).");
    prm.add_parameter(
      "r_t",
      r_t,
      "Tangential regularization parameter of the three roles that have no "
      "number of their own: a number, or with 'Scale = automatic' also "
      "automatic, which is 1 where the contact points are the multiplier "
      "nodes and 0.25 for other rules (the answer drifts with it there).");
    prm.add_parameter("r_n status",
                      r_n_status,
                      "r_n in the contact status S_c(lambda_n - r_n d_n): a "
                      "number or r_n.");
    prm.add_parameter("r_n augmentation",
                      r_n_augmentation,
                      "r_n in the contact force lambda_n - r_n d_n: a number "
                      "or r_n. With a value other than that of the status the "
                      "force jumps where the status changes; only for nodal "
                      "quadrature is that harmless.");
    prm.add_parameter("r_n law",
                      r_n_law,
                      "r_n in the weak Signorini condition (scales its rows "
                      "for open points): a number or r_n.");
    prm.add_parameter("r_t status",
                      r_t_status,
                      "r_t in the slip status S_f(Lambda + r_t d_t): a number "
                      "or r_t. Must not exceed twice 'r_t law'.");
    prm.add_parameter("r_t augmentation",
                      r_t_augmentation,
                      "r_t in the friction force Lambda + r_t d_t: a number or "
                      "r_t.");
    prm.add_parameter("r_t law",
                      r_t_law,
                      "r_t in the weak Coulomb condition: a number or r_t.");
  }



  void
  RegularizationParameters::check(const std::string &path,
                                  const double       automatic_r_t) const
  {
    const std::vector<std::string> automatic = {"automatic"};
    if (scale == "plain" && (r_n == "automatic" || r_t == "automatic"))
      throw UserError("'" + path +
                      "': with 'Scale = plain' both 'r_n' and 'r_t' must be "
                      "numbers.");
    number_or_word(r_n, automatic, path + "/r_n");
    number_or_word(r_n_status, {"r_n"}, path + "/r_n status");
    number_or_word(r_n_augmentation, {"r_n"}, path + "/r_n augmentation");
    number_or_word(r_n_law, {"r_n"}, path + "/r_n law");
    const double common     = r_t == "automatic"
                                ? automatic_r_t
                                : number_or_word(r_t, automatic, path + "/r_t");
    const auto   tangential = [&](const std::string &text,
                                const std::string &name) {
      const double value = number_or_word(text, {"r_t"}, path + "/" + name);
      return std::isnan(value) ? common : value;
    };
    const double status = tangential(r_t_status, "r_t status");
    const double law    = tangential(r_t_law, "r_t law");
    tangential(r_t_augmentation, "r_t augmentation");
    if (status > 2. * law)
      throw UserError("'" + path + "/r_t status' = " + std::to_string(status) +
                      " is more than twice 'r_t law' = " + std::to_string(law) +
                      ": points that slip against their traction would then "
                      "satisfy the discrete equations. Lower it.");
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
                      "Boundary ids of the slave body.",
                      Patterns::List(Patterns::Integer(0)));
    prm.add_parameter("Master body", master_body, "Body that is projected on.");
    prm.add_parameter("Master boundary",
                      master_boundary,
                      "Boundary ids of the master body.",
                      Patterns::List(Patterns::Integer(0)));
    prm.add_parameter("Friction",
                      friction,
                      "none, Coulomb (threshold mu times the pressure) or "
                      "Tresca (given threshold).",
                      Patterns::Selection("none|Coulomb|Tresca"));
    prm.add_parameter("Friction coefficient",
                      friction_coefficient,
                      "Coulomb's mu.",
                      Patterns::Double(0.));
    prm.add_parameter("Tresca threshold",
                      tresca_threshold,
                      "Largest tangential traction [stress] for Tresca.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Threshold",
      threshold_form,
      "Friction threshold while it is live: augmented is "
      "-mu (lambda_n - r_n d_n), never negative at a closed point; plain is "
      "the "
      "paper's -mu lambda_n. Both are the same at the solution.",
      Patterns::Selection("augmented|plain"));
    prm.add_parameter("Multiplier space",
                      multiplier_space,
                      "Multipliers on the slave faces: of the degree of the "
                      "displacement, or linear with nodes at the vertices (the "
                      "P2-P1 element if the displacement degree is 2).",
                      Patterns::Selection("displacement trace|vertices"));
    prm.add_parameter("Quadrature",
                      quadrature,
                      "Rule that places the contact points on a slave face.",
                      Patterns::Selection("nodal|Gauss|Simpson|Newton-Cotes"));
    prm.add_parameter("Quadrature order",
                      quadrature_order,
                      "Gauss: points per direction. Simpson: subintervals. "
                      "Newton-Cotes: intervals. Not used by nodal.",
                      Patterns::Integer(1, 20));
    prm.add_parameter("Normals",
                      normals,
                      "facet: the master facet's own normal. smoothed: "
                      "interpolated from nodal averages, continuous across "
                      "facets.",
                      Patterns::Selection("facet|smoothed"));
    prm.add_parameter("Smoothing angle",
                      smoothing_angle,
                      "Facets whose reference normals differ by more than this "
                      "angle [degrees] are not averaged (sharp edges stay "
                      "sharp).",
                      Patterns::Double(0., 180.));
    prm.add_parameter("Search distance",
                      search_distance,
                      "Slave points farther than this from the master are not "
                      "paired [length]. 0: four times the largest slave face.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Projection tolerance",
      projection_tolerance,
      "How far beyond the end of the master surface, as a fraction of the face "
      "size, a slave point may lie sideways to be paired with it; 0.8 times "
      "its distance from the master is added (so 5 times this in all for a "
      "point level with the surface).",
      Patterns::Double(0.));
    prm.add_parameter(
      "Facet overlap",
      facet_overlap,
      "A point that has changed its master facet six times in a load step "
      "keeps it until its projection is this fraction of the facet outside (10 "
      "times as much after twelve changes, 50 times after eighteen, 0.5 at "
      "most): points at a kink between facets then do not hop for ever.",
      Patterns::Double(0., 0.2));
    prm.add_parameter("Gap offset",
                      gap_offset,
                      "Function of x, y, z, t added to the gap [length]: a "
                      "positive value opens it.");
    prm.add_parameter("Excluded boundaries",
                      excluded_boundaries,
                      "Nodes on these boundary ids of the slave body carry no "
                      "contact.",
                      Patterns::List(Patterns::Integer(0)));
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
    if (friction != "Coulomb" && friction_coefficient > 0.)
      throw UserError("'" + path +
                      "/Friction coefficient' is given, but 'Friction = " +
                      friction + "'. Set 'Friction = Coulomb' or remove it.");
    if (friction == "Coulomb" && !(friction_coefficient > 0.))
      throw UserError("'" + path +
                      "/Friction coefficient' must be larger than 0 with "
                      "'Friction = Coulomb'. For frictionless contact set "
                      "'Friction = none'.");
    if (friction == "Tresca" && !(tresca_threshold > 0.))
      throw UserError("'" + path +
                      "/Tresca threshold' must be larger than 0 with 'Friction "
                      "= Tresca'.");
    regularization.check(path + "/Regularization", automatic_r_t(quadrature));
  }
} // namespace stickslip
