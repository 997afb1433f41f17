#include <stickslip/strategy/load_stepping_parameters.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// As a user would write it.
    std::string
    short_text(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }
  } // namespace



  const Choices<Predictor> &
  all_predictors()
  {
    static const Choices<Predictor> choices = {{"linear", Predictor::linear},
                                               {"none", Predictor::none}};
    return choices;
  }



  void
  LoadSteppingParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("End time",
                      end_time,
                      "Load time t at the end; it starts at 0.",
                      Patterns::Double());
    prm.add_parameter("Initial step",
                      initial_step,
                      "First step in t.",
                      Patterns::Double());
    prm.add_parameter("Minimum step",
                      minimum_step,
                      "The run stops if a step this small fails. 0: a "
                      "thousandth of the initial step.",
                      Patterns::Double(0.));
    prm.add_parameter("Maximum step",
                      maximum_step,
                      "Steps do not grow beyond this. 0: the initial step.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Cut factor",
      cut_factor,
      expert(
        "A failed step is multiplied by this. A step also fails if it takes "
        "more than a hundred Newton iterations and three times those of any of "
        "the last three steps, unless the cut step would be too small; with "
        "another 'Algorithm/Name' than automatic more than ten times "
        "'Algorithm/Newton/Max iterations' instead of a hundred."),
      Patterns::Double(0.01, 0.99));
    prm.add_parameter(
      "Growth factor",
      growth_factor,
      expert("After an easy step the next one is multiplied by this; "
             "after a cut when two steps in a row have been easy, or "
             "up to eight if larger steps keep failing."),
      Patterns::Double(1.));
    prm.add_parameter("Easy iterations",
                      easy_iterations,
                      "A step is easy if it took at most this many Newton "
                      "iterations.",
                      Patterns::Integer(0));
    add_choice(prm,
               "Predictor",
               predictor,
               all_predictors(),
               expert("Where Newton starts in a step. linear: the "
                      "displacements are extrapolated from the last step, and "
                      "rigid bodies are where their motion has them "
                      "(not after a cut or a requested time). none: "
                      "the accepted state."));
    prm.add_parameter(
      "Requested times",
      requested_times,
      "Times that steps must hit exactly, for instance where the "
      "load changes its direction.",
      Patterns::List(Patterns::Double()));
    prm.add_parameter(
      "Leap over snaps",
      leaps_over_snaps,
      "Where no step down to the minimum can be solved, larger ones from the "
      "same state are tried, each twice as large, up to 'Initial step': if a "
      "body snaps or a loaded point slides off an end, there is no state "
      "nearby, only one beyond. A warning says from where to where.");
    prm.add_parameter(
      "Locate contact changes",
      locates_contact_changes,
      "Steps end where a contact pair closes that was open, at its first "
      "point, or opens altogether: a step with such a change is solved several "
      "times, each with half of what is left of the doubt about its time, and "
      "the next step is as large as without it.");
    prm.add_parameter(
      "Contact change tolerance",
      contact_change_tolerance,
      expert("With 'Locate contact changes': a step ends at most this fraction "
             "of 'Initial step' after a change, never before it."),
      Patterns::Double(1e-9, 1.));
    prm.enter_subsection("Stabilization");
    prm.add_parameter(
      "Factor",
      stabilization_factor,
      "Viscous forces that let a body snap past a limit point of its "
      "quasi-static path: Factor * M T / L^2 * (u - u_old) / dt per volume, "
      "with the longitudinal modulus M of each material, the 'End time' T and "
      "the diagonal L of the model. Small values (1e-7 to 1e-4) suffice, since "
      "steps become small where a body snaps. What these forces dissipate is "
      "'stabilization_work' among the results and must be small compared with "
      "'external_work'. 0: none.",
      Patterns::Double(0.));
    prm.leave_subsection();
  }



  void
  LoadSteppingParameters::check(const std::string &path) const
  {
    const auto require = [&path](const bool ok, const std::string &text) {
      if (!ok)
        throw UserError("'" + path + "/" + text);
    };
    require(end_time > 0., "End time' must be larger than 0.");
    require(initial_step > 0., "Initial step' must be larger than 0.");
    require(minimum_step <= initial_step,
            "Minimum step' must not exceed 'Initial step'.");
    require(maximum_step == 0. || maximum_step >= initial_step,
            "Maximum step' is " + short_text(maximum_step) +
              ", but has to be 0 or at least 'Initial step', which is " +
              short_text(initial_step) + ".");
    for (const double time : requested_times)
      require(time > 0. && time <= end_time,
              "Requested times' has " + short_text(time) +
                ", but all have to lie between 0 and 'End time', which is " +
                short_text(end_time) + ".");
  }



  void
  LoadSteppingParameters::request(const std::vector<double> &times)
  {
    for (const double time : times)
      if (time > 0. && time < end_time &&
          std::find(requested_times.begin(), requested_times.end(), time) ==
            requested_times.end())
        requested_times.push_back(time);
  }
} // namespace stickslip
