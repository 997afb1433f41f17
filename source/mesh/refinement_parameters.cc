#include <stickslip/mesh/refinement_parameters.h>

#include <stickslip/base/user_error.h>

#include <algorithm>

namespace stickslip
{
  const Choices<RefinementType> &
  all_refinement_types()
  {
    static const Choices<RefinementType> choices = {
      {"box", RefinementType::box},
      {"sphere", RefinementType::sphere},
      {"condition", RefinementType::condition},
      {"boundary", RefinementType::boundary},
      {"contact", RefinementType::contact}};
    return choices;
  }



  void
  RefinementParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Type",
      type,
      all_refinement_types(),
      "Which cells are refined, by their undeformed position. 'box': those "
      "that meet the box between First corner and Second corner. 'sphere': "
      "those that meet the one with Centre and Radius (2D: a circle). "
      "'condition': those with a vertex or their centre where Condition is "
      "not zero. 'boundary': those within Distance of Boundary. 'contact': "
      "those of either body of Contact pair within Distance of the other "
      "one's contact surface; a rigid tool has no cells, but a surface.");
    prm.add_parameter("Levels",
                      levels,
                      "How often, after 'Mesh/Global refinements': each level "
                      "halves the size of the cells.",
                      Patterns::Integer(1, 12));
    prm.add_parameter("Body",
                      bodies,
                      "Names of bodies whose cells are refined, separated by "
                      "commas. Empty: all (with 'boundary': that of the "
                      "boundary has to be named).");
    prm.add_parameter("First corner",
                      first_corner,
                      "Of a box: its smallest coordinates.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Second corner",
                      second_corner,
                      "Of a box: its largest coordinates.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Centre",
                      centre,
                      "Of a sphere.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Radius",
                      radius,
                      "Of a sphere [length].",
                      Patterns::Double(0.));
    prm.add_parameter("Condition",
                      condition,
                      "An expression of x, y, z, for instance "
                      "'y < 2 & abs(x) < 3'.",
                      Patterns::Anything());
    prm.add_parameter("Boundary",
                      boundary,
                      "The body's boundary ids or names.");
    prm.add_parameter("Contact pair",
                      contact_pair,
                      "Name of a section of Contact.");
    prm.add_parameter("Distance",
                      distance,
                      "From a boundary or the other contact surface [length]. "
                      "Choose it so that what slides stays among fine cells.",
                      Patterns::Double(0.));
    prm.add_parameter("Buffer layers",
                      buffer_layers,
                      "Layers of cells around those of the rule that are "
                      "refined with them, at each level: more of them make a "
                      "slower transition.",
                      Patterns::Integer(0, 20));
  }



  void
  RefinementParameters::check(const std::string &path,
                              const unsigned int dim) const
  {
    const std::string &type_name = name_of(type, all_refinement_types());
    const auto check_use = [&](const RefinementType of, // or the other one
                               const RefinementType or_of,
                               const bool           is_given,
                               const std::string   &name) {
      const bool is_needed = type == of || type == or_of;
      if (is_needed && !is_given)
        throw UserError(path + "/" + name +
                        " is missing; 'Type = " + type_name +
                        "' needs it, and a length greater than zero where it "
                        "is one.");
      if (!is_needed && is_given)
        throw UserError(path + "/" + name + " is given, but 'Type = " +
                        type_name + "' has no use for it.");
    };
    const auto box = RefinementType::box, sphere = RefinementType::sphere,
               near = RefinementType::boundary, pair = RefinementType::contact,
               where = RefinementType::condition;
    check_use(box, box, !first_corner.empty(), "First corner");
    check_use(box, box, !second_corner.empty(), "Second corner");
    check_use(sphere, sphere, !centre.empty(), "Centre");
    check_use(sphere, sphere, radius > 0., "Radius");
    check_use(where, where, !condition.empty(), "Condition");
    check_use(near, near, !boundary.empty(), "Boundary");
    check_use(pair, pair, !contact_pair.empty(), "Contact pair");
    check_use(near, pair, distance > 0., "Distance");

    const auto check_point = [&](const std::vector<double> &point,
                                 const std::string         &name) {
      if (!point.empty() && point.size() != dim)
        throw UserError(path + "/" + name + " has " +
                        std::to_string(point.size()) + " coordinates; in " +
                        std::to_string(dim) + "D a point has " +
                        std::to_string(dim) + ".");
    };
    check_point(first_corner, "First corner");
    check_point(second_corner, "Second corner");
    check_point(centre, "Centre");
    for (unsigned int d = 0; d < first_corner.size(); ++d)
      if (!(first_corner[d] <= second_corner[d]))
        throw UserError(path +
                        "/Second corner: a coordinate is smaller than "
                        "that of 'First corner'.");
    if (type == near && bodies.size() != 1)
      throw UserError(path +
                      "/Body has to name one body, that of 'Boundary'; " +
                      std::to_string(bodies.size()) + " are named.");
    if (type == pair && !bodies.empty())
      throw UserError(path +
                      "/Body is given, but 'Type = contact' refines the bodies "
                      "of the pair.");
  }
} // namespace stickslip
