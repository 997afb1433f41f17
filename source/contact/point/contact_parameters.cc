#include <stickslip/contact/point/contact_parameters.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

namespace stickslip
{
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



  const Choices<Facets> &
  all_facets()
  {
    static const Choices<Facets> choices = {{"curved", Facets::curved},
                                            {"flat", Facets::flat}};
    return choices;
  }



  const Choices<Normals> &
  all_normals()
  {
    static const Choices<Normals> choices = {{"facet", Normals::facet},
                                             {"smoothed", Normals::smoothed}};
    return choices;
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
                      "Boundary ids or names of the slave body. all: its "
                      "whole boundary.");
    prm.add_parameter("Master body", master_body, "Body that is projected on.");
    prm.add_parameter(
      "Master boundary",
      master_boundary,
      "Boundary ids or names of the master body. all: its "
      "whole boundary. A rigid tool without a mesh needs none.");
    add_choice(prm,
               "Law",
               law,
               all_pair_laws(),
               "contact: the surfaces may part and touch. tied: they are "
               "bonded where they are opposite each other at the start and "
               "neither part nor slip; their meshes need not match. no "
               "separation: they neither part nor overlap, but slip freely "
               "(by little: partners stay those of the start). Gaps and "
               "overlaps that a tied pair or one without separation has at the "
               "start stay as they are, without stress.");
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
                      "in axisymmetric models with segments, as faces that "
                      "end on the axis have such weights there; the "
                      "displacement trace in all other cases."));
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
               "Facets",
               facets,
               all_facets(),
               "What the facets of straight cells stand for, with "
               "'Quadrature = segments'. curved: the smooth surface through "
               "their vertices, whose curvature is taken from the angles "
               "between neighbours (up to 42 degrees): gaps are those of this "
               "surface; where neither side is concave anywhere the slave is "
               "parallel to a round master between its nodes, or keeps its "
               "facets. flat: themselves, for bodies that really are "
               "polygons.");
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
    if (is_bilateral())
      check_bilateral(path);
    initial_gaps.check(path);
    regularization.check(path + "/Regularization", quadrature);
  }



  void
  ContactPairParameters::check_bilateral(const std::string &path) const
  {
    const std::string given =
      "', but 'Law = " + name_of(law, all_pair_laws()) + "': ";
    if (has_friction())
      throw UserError(
        "'" + path + "/Friction = " + name_of(friction, all_frictions()) +
        given + "friction needs 'Law = contact'. Remove one of them.");
    if (!has_segments())
      throw UserError("'" + path + "/Quadrature = " +
                      name_of(quadrature, all_contact_rules()) + given +
                      "that needs 'Quadrature = segments', which is exact "
                      "where meshes do not match.");
    if (initial_gaps.treatment != InitialGapTreatment::as_meshed)
      throw UserError("'" + path + "/Initial gaps = closed" + given +
                      "all gaps of the start are kept without stress anyway. "
                      "Remove it, or set 'Overlap ramp time' to close them.");
  }



  void
  ContactPairParameters::check_self_contact(const std::string &path) const
  {
    const std::string given =
      "', but the slave and the master set share a boundary of body '" +
      slave_body + "': ";
    if (!has_segments())
      throw UserError("'" + path + "/Quadrature = " +
                      name_of(quadrature, all_contact_rules()) + given +
                      "a surface that meets itself needs 'Quadrature = "
                      "segments'. Or name other boundaries.");
    if (is_bilateral())
      throw UserError("'" + path + "/Law = " + name_of(law, all_pair_laws()) +
                      given +
                      "a surface that meets itself needs 'Law = contact'. To "
                      "bond two parts of it give them boundaries of their "
                      "own.");
    if (initial_gaps.treatment != InitialGapTreatment::as_meshed)
      throw UserError("'" + path + "/Initial gaps = closed" + given +
                      "which of its points are slave can change, and so the "
                      "gaps that would be kept. Take 'as meshed'.");
  }
} // namespace stickslip
