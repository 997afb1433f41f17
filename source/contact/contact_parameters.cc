#include <stickslip/base/user_error.h>

#include <stickslip/contact/contact_parameters.h>

#include <deal.II/base/utilities.h>

namespace stickslip
{
  namespace
  {
    void
    check_factor(const std::string &text,
                 const std::string &keyword,
                 const std::string &path)
    {
      if (text == keyword || text == "automatic")
        return;
      double value = 0.;
      try
        {
          value = Utilities::string_to_double(text);
        }
      catch (...)
        {
          throw UserError("'" + path + " = " + text +
                          "': expected a number, 'automatic' or '" + keyword +
                          "'.");
        }
      if (!(value > 0.))
        throw UserError("'" + path + " = " + text +
                        "': must be larger than 0.");
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
    prm.add_parameter("r_n",
                      r_n,
                      "Normal regularization parameter of all three roles "
                      "(status, augmentation, law) that do not name their own.",
                      Patterns::Double(1e-300));
    prm.add_parameter("r_t",
                      r_t,
                      "Tangential regularization parameter of all three roles "
                      "that do not name their own.",
                      Patterns::Double(1e-300));
    prm.add_parameter("r_n status",
                      r_n_status,
                      "r_n in the contact status S_c(lambda_n - r_n d_n): a "
                      "number or r_n.");
    prm.add_parameter(
      "r_n augmentation",
      r_n_augmentation,
      "r_n in the contact force lambda_n - r_n d_n: a number, r_n, or "
      "automatic "
      "(r_n where the contact points are the multiplier nodes, so that the "
      "answer does not depend on it; 1e-4 r_n for quadrature with more points "
      "than multipliers, where the answer drifts with it).");
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
                      "r_t in the friction force Lambda + r_t d_t: a number, "
                      "r_t, or automatic (as for r_n augmentation).");
    prm.add_parameter("r_t law",
                      r_t_law,
                      "r_t in the weak Coulomb condition: a number or r_t.");
  }



  void
  RegularizationParameters::check(const std::string &path) const
  {
    check_factor(r_n_status, "r_n", path + "/r_n status");
    check_factor(r_n_augmentation, "r_n", path + "/r_n augmentation");
    check_factor(r_n_law, "r_n", path + "/r_n law");
    check_factor(r_t_status, "r_t", path + "/r_t status");
    check_factor(r_t_augmentation, "r_t", path + "/r_t augmentation");
    check_factor(r_t_law, "r_t", path + "/r_t law");
    const auto number = [&](const std::string &text) {
      return text == "r_t" || text == "automatic"
               ? r_t
               : Utilities::string_to_double(text);
    };
    if (number(r_t_status) > 2. * number(r_t_law))
      throw UserError(
        "'" + path + "/r_t status' = " + std::to_string(number(r_t_status)) +
        " is more than twice 'r_t law' = " + std::to_string(number(r_t_law)) +
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
                      "Boundary ids of the slave body.");
    prm.add_parameter("Master body", master_body, "Body that is projected on.");
    prm.add_parameter("Master boundary",
                      master_boundary,
                      "Boundary ids of the master body.");
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
      "How far beyond the end of the master surface a slave "
      "point may lie to be paired with it, as a fraction of the "
      "face size.",
      Patterns::Double(0.));
    prm.add_parameter("Facet overlap",
                      facet_overlap,
                      "A point keeps its master facet until its projection is "
                      "this fraction of the facet outside: points at a kink "
                      "between facets then do not hop for ever.",
                      Patterns::Double(0., 0.2));
    prm.add_parameter("Gap offset",
                      gap_offset,
                      "Function of x, y, z, t added to the gap [length]: a "
                      "positive value opens it.");
    prm.add_parameter("Excluded boundaries",
                      excluded_boundaries,
                      "Nodes on these boundary ids of the slave body carry no "
                      "contact.");
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
    regularization.check(path + "/Regularization");
  }
} // namespace stickslip
