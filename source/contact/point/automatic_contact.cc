#include <stickslip/contact/point/automatic_contact.h>

#include <stickslip/base/user_error.h>

namespace stickslip
{
  void
  AutomaticContact::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Automatic",
      active,
      "Contact between all bodies, wherever they are near each other or come "
      "near each other: two bodies that no pair below names together get a "
      "pair of their own, called <slave>_on_<master>: the whole boundary of "
      "the slave against that of the master, without symmetry planes and "
      "periodic boundaries. Who is slave of whom, and why, is said at the "
      "start.");
    prm.add_parameter("Automatic friction coefficient",
                      friction_coefficient,
                      "With 'Automatic': Coulomb's mu of these pairs. 0: no "
                      "friction.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Automatic self contact",
      self_contact,
      "With 'Automatic': each body that can deform gets a pair with itself, "
      "too, called <body>_on_itself, for what folds, buckles or closes a gap "
      "of its own. Not with an adaptive mesh.");
  }



  void
  AutomaticContact::check(const std::string &path) const
  {
    if (!active && friction_coefficient > 0.)
      throw UserError("'" + path +
                      "/Automatic friction coefficient' is given, but "
                      "'Automatic = false'. Set 'Automatic = true' or remove "
                      "it.");
    if (!active && self_contact)
      throw UserError("'" + path +
                      "/Automatic self contact = true' is given, but "
                      "'Automatic = false'. Set 'Automatic = true' or remove "
                      "it.");
  }



  ContactPairParameters
  AutomaticContact::pair() const
  {
    ContactPairParameters parameters;
    parameters.is_automatic = true;
    // The side of a block whose corner has come into a soft surface must not be
    // pushed away by the slope in front of it.
    parameters.least_cosine = 0.5;
    if (friction_coefficient > 0.)
      {
        parameters.friction             = Friction::Coulomb;
        parameters.friction_coefficient = friction_coefficient;
      }
    return parameters;
  }
} // namespace stickslip
