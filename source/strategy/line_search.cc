#include <stickslip/strategy/line_search.h>

#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/residual_monitors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Share of the step length by which a step has to reduce the merit.
    constexpr double sufficient_decrease = 0.1;

    /// Factor by which the merit of a state of roundoff may grow.
    constexpr double growth_of_roundoff = 10.;

    /// Prescribed displacements are as good as applied if no more than this is
    /// missing of what was to be applied. Those of bodies that turn are never
    /// quite, before the end.
    constexpr double negligible_share = 1e-2;

    /// Iterates whose largest merit is the reference.
    constexpr unsigned int n_remembered_iterates = 2;
  } // namespace



  void
  MeritReference::restart()
  {
    last_merits.clear();
  }



  void
  MeritReference::add(const NewtonIteration &state)
  {
    if (!prescribed_at_start)
      prescribed_at_start = state.prescribed;
    if (*prescribed_at_start > 0. &&
        state.prescribed > negligible_share * *prescribed_at_start)
      return;
    if (!state.compares)
      return;
    last_merits.push_back(state.merit);
    if (last_merits.size() > n_remembered_iterates)
      last_merits.pop_front();
  }



  double
  MeritReference::value() const
  {
    return last_merits.empty()
             ? std::numeric_limits<double>::infinity()
             : *std::max_element(last_merits.begin(), last_merits.end());
  }



  NewtonIteration
  state_at(NewtonProblem &problem, const double length, LA::BlockVector &x)
  {
    problem.limit(x);
    NewtonIteration state = problem.residual(x);
    state.step_length     = length;
    return state;
  }



  bool
  is_finite(const NewtonIteration &state)
  {
    return std::isfinite(residual_size(state)) && std::isfinite(state.merit);
  }



  LineSearchResult
  advance(NewtonProblem              &problem,
          const LA::BlockVector      &increment,
          const double                reference,
          const ConvergenceCriterion &criterion,
          const unsigned int          max_halvings,
          LA::BlockVector            &x)
  {
    const LA::BlockVector start(x);
    const auto            try_step = [&](const double length) {
      x = start;
      x.add(length, increment);
      return state_at(problem, length, x);
    };
    const auto is_good_enough = [&](const NewtonIteration &state) {
      return state.merit <
               (1. - sufficient_decrease * state.step_length) * reference ||
             (state.step_length == 1. && criterion.is_near_roundoff(state) &&
              state.merit < growth_of_roundoff * reference);
    };

    NewtonIteration best;
    bool            has_best = false, full_step_is_admissible = false;
    std::string     reason;
    FailurePlace    place;
    double          length = 1.;
    for (unsigned int halvings = 0; halvings <= max_halvings;
         ++halvings, length *= 0.5)
      {
        const NewtonIteration state = try_step(length);
        if (!is_finite(state))
          {
            if (reason.empty())
              reason = "the residual is not a number";
            continue;
          }
        if (!problem.is_admissible(reason))
          {
            place = problem.inadmissible_place();
            continue;
          }
        if (length == 1.)
          full_step_is_admissible = true;
        if (is_good_enough(state))
          return {state, true, full_step_is_admissible};
        if (!has_best || state.merit < best.merit)
          best = state;
        has_best = true;
      }
    if (!has_best)
      throw NoConvergence("Newton", reason, FailureCause::inadmissible, place);
    return {try_step(best.step_length), false, full_step_is_admissible};
  }
} // namespace stickslip
