#include <stickslip/strategy/newton_parameters.h>

#include <stickslip/base/expert_parameter.h>

namespace stickslip
{
  const Choices<LineSearch> &
  all_line_searches()
  {
    static const Choices<LineSearch> choices = {{"automatic",
                                                 LineSearch::automatic},
                                                {"none", LineSearch::none}};
    return choices;
  }



  const Choices<Forcing> &
  all_forcings()
  {
    static const Choices<Forcing> choices = {{"none", Forcing::none},
                                             {"careful", Forcing::careful},
                                             {"Eisenstat-Walker",
                                              Forcing::eisenstat_walker}};
    return choices;
  }



  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Max iterations",
      max_iterations,
      "Newton iterations after which a solve has failed; half "
      "as many more while the residual is on its way down, each "
      "three iterations to less than half of all before.",
      Patterns::Integer(1));
    prm.add_parameter(
      "Equilibrium tolerance",
      equilibrium_tolerance,
      "Largest ||F_int + F_contact - F_ext|| / max(||F_ext||, ||reactions||) "
      "(eq. 25 of the paper). A hundred times as much is sufficient after a "
      "full step that has changed the state by roundoff only.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Contact tolerance",
      contact_tolerance,
      "Largest violation of a weak contact condition: gap over the size of the "
      "slave face, or error of the friction multiplier.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Increment tolerance",
      increment_tolerance,
      "Largest relative change of displacements and multipliers in the last "
      "iteration (the further terms of eq. 26).",
      Patterns::Double(0.));
    add_choice(
      prm,
      "Line search",
      line_search,
      all_line_searches(),
      expert("automatic: the step is halved until the residual, with contact "
             "rows as forces, is smaller than the largest of the last "
             "iterations. none: full steps (halved only if a cell would "
             "invert), for comparison."));
    prm.add_parameter("Max halvings",
                      max_halvings,
                      expert(
                        "How often a step is halved by the line search, or "
                        "because it inverts a cell."),
                      Patterns::Integer(0, 30));
    add_choice(
      prm,
      "Forcing",
      forcing,
      all_forcings(),
      "How exactly an iterative linear solver works. none: always to its "
      "'Relative tolerance'. careful: to what the Newton iteration can make "
      "use of, at least four digits, so that contact statuses come out as "
      "with exact solves. Eisenstat-Walker: likewise, but at least two digits; "
      "the first iterations may take another path, which can end in another "
      "step size or, with friction, in another state, above all of bodies that "
      "only contact holds. MUMPS is exact anyway.");
  }
} // namespace stickslip
