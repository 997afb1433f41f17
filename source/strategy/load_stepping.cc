#include <stickslip/strategy/load_stepping.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Times closer than this fraction of the whole interval are the same.
    constexpr double same_time = 1e-10;

    /// A rest of at most this many steps is one step.
    constexpr double whole_rest = 1. + 1e-6;

    /// A rest below this many steps, larger than one, is made in two halves.
    constexpr double shared_rest = 1.5;

    /// Easy steps in a row that growth waits for after a first cut.
    constexpr unsigned int first_growth_delay = 2;

    /// ... and after many.
    constexpr unsigned int longest_growth_delay = 8;



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
        "the last three steps, unless the cut step would be too small."),
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



  LoadStepping::LoadStepping(const LoadSteppingParameters &given)
    : parameters([&given] {
      LoadSteppingParameters p = given;
      if (p.minimum_step == 0.)
        p.minimum_step = 1e-3 * p.initial_step;
      if (p.maximum_step == 0.)
        p.maximum_step = p.initial_step;
      std::sort(p.requested_times.begin(), p.requested_times.end());
      return p;
    }())
    , step(parameters.initial_step)
    , growth_delay(first_growth_delay, longest_growth_delay)
  {}



  bool
  LoadStepping::finished() const
  {
    return current_time >= parameters.end_time * (1. - same_time);
  }



  bool
  LoadStepping::is_at_requested_time() const
  {
    return std::any_of(parameters.requested_times.begin(),
                       parameters.requested_times.end(),
                       [this](const double time) {
                         return std::abs(time - current_time) <=
                                same_time * parameters.end_time;
                       });
  }



  double
  size_up_to_change(const ContactChangeSearch &search, const double tolerance)
  {
    if (search.with == 0.)
      return search.without;
    if (search.with - search.without <= tolerance)
      return search.with;
    return 0.5 * (search.with + search.without);
  }



  bool
  LoadStepping::locate_contact_change(const bool contact_changes)
  {
    if (!parameters.locates_contact_changes || search_is_over)
      return false;
    const double size                                = present_size();
    (contact_changes ? search.with : search.without) = size;
    const double next                                = size_up_to_change(search,
                                          parameters.contact_change_tolerance *
                                            parameters.initial_step);
    if (next == size)
      return false;
    // the whole step ends exactly where it would without a search
    shortened_to = next < whole_next_time() - current_time ? next : 0.;
    return true;
  }



  void
  LoadStepping::forget_search()
  {
    search         = ContactChangeSearch();
    shortened_to   = 0.;
    search_is_over = false;
  }



  double
  LoadStepping::next_time() const
  {
    return shortened_to > 0. ? current_time + shortened_to : whole_next_time();
  }



  double
  LoadStepping::whole_next_time() const
  {
    double target = parameters.end_time;
    for (const double requested : parameters.requested_times)
      if (requested > current_time + same_time * parameters.end_time)
        {
          target = std::min(target, requested);
          break;
        }
    // A step that nearly reaches the target takes all of it; a rest is shared,
    // so that no tiny step remains.
    const double rest = target - current_time;
    if (rest <= whole_rest * step)
      return target;
    if (rest < shared_rest * step && step < parameters.maximum_step)
      return current_time + 0.5 * rest;
    return current_time + step;
  }



  void
  LoadStepping::accept_step(const unsigned int newton_iterations)
  {
    current_time = next_time();
    forget_search();
    ++n_accepted;
    if (has_grown)
      growth_delay.succeed();
    const bool is_easy = newton_iterations <= parameters.easy_iterations;
    if (is_easy)
      growth_delay.advance();
    else
      growth_delay.restart();
    has_grown =
      is_easy && !growth_delay.is_waiting() && step < parameters.maximum_step;
    if (has_grown)
      {
        step =
          std::min(step * parameters.growth_factor, parameters.maximum_step);
        growth_delay.restart();
      }
  }



  bool
  LoadStepping::can_be_cut() const
  {
    return shortened_to > 0. ||
           parameters.cut_factor * (next_time() - current_time) >=
             parameters.minimum_step * (1. - same_time);
  }



  bool
  LoadStepping::cut_step()
  {
    if (shortened_to > 0.)
      {
        forget_search();
        search_is_over = true;
        return true;
      }
    const bool is_large_enough = can_be_cut();
    forget_search();
    step      = parameters.cut_factor * (next_time() - time());
    has_grown = false;
    growth_delay.fail();
    return is_large_enough;
  }



  std::string
  LoadStepping::describe_last_step() const
  {
    std::ostringstream text;
    text << "Load step to t = " << next_time() << " of size "
         << next_time() - current_time
         << " failed and the next would be below 'Load stepping/Minimum "
            "step' = "
         << parameters.minimum_step;
    return text.str();
  }



  LoadSteppingState
  LoadStepping::state() const
  {
    return {current_time,
            step,
            n_accepted,
            growth_delay.wait_length(),
            growth_delay.steps_left(),
            has_grown};
  }



  void
  LoadStepping::resume(const LoadSteppingState &state)
  {
    current_time = state.time;
    n_accepted   = state.step;
    // the limits may be new, and a failed run has cut below the minimum
    step = std::min(std::max(state.step_size, parameters.minimum_step),
                    parameters.maximum_step);
    growth_delay.resume(state.growth_delay, state.growth_delay_left);
    has_grown = state.has_grown;
  }
} // namespace stickslip
