#include <stickslip/strategy/load_stepping.h>

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
  } // namespace



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
    if (rest < shared_rest * step && step < parameters.maximum_step &&
        !is_leaping())
      return current_time + 0.5 * rest;
    return current_time + step;
  }



  void
  LoadStepping::accept_step(const unsigned int newton_iterations)
  {
    current_time = next_time();
    forget_search();
    forget_failures();
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
           (!is_leaping() &&
            parameters.cut_factor * (next_time() - current_time) >=
              parameters.minimum_step * (1. - same_time));
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
    largest_failed = std::max(largest_failed, present_size());
    step           = parameters.cut_factor * (next_time() - time());
    has_grown      = false;
    growth_delay.fail();
    return is_large_enough;
  }



  bool
  LoadStepping::leap()
  {
    if (!is_leaping())
      smallest_failed = present_size();
    largest_failed = std::max(largest_failed, present_size());
    step           = std::min(2. * largest_failed, parameters.initial_step);
    search_is_over = true;
    if (parameters.leaps_over_snaps &&
        present_size() > largest_failed + same_time * parameters.end_time)
      return true;
    step = smallest_failed;
    forget_failures();
    return false;
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



  std::string
  LoadStepping::describe_leap() const
  {
    std::ostringstream text;
    text << "steps from t = " << current_time << " of sizes from "
         << smallest_failed << " to " << largest_failed
         << " failed, one to t = " << next_time()
         << " was solved. Something may have snapped: what happens between "
            "these times is not resolved, and the state after it depends on "
            "the step. 'Load stepping/Stabilization' or prescribed "
            "displacements instead of forces may follow it; 'Load stepping/"
            "Leap over snaps = false' ends the run there.";
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
