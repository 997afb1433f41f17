#include <stickslip/strategy/line_search.h>

#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/residual_monitors.h>

#include <cmath>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Share of the step length by which a step has to reduce the residual.
    constexpr double sufficient_decrease = 0.1;



    bool
    decreases_enough(const NewtonIteration &before,
                     const NewtonIteration &state)
    {
      return residual_size(state) <
             (1. - sufficient_decrease * state.step_length) *
               residual_size(before);
    }
  } // namespace



  NewtonIteration
  advance(NewtonProblem         &problem,
          const LA::BlockVector &increment,
          const NewtonIteration &before,
          const bool             needs_decrease,
          const unsigned int     max_halvings,
          LA::BlockVector       &x)
  {
    const LA::BlockVector start(x);
    const auto            try_step = [&](const double length) {
      x = start;
      x.add(length, increment);
      problem.limit(x);
      NewtonIteration state = problem.residual(x);
      state.step_length     = length;
      return state;
    };

    NewtonIteration best;
    bool            has_best = false;
    std::string     reason;
    FailurePlace    place;
    double          length = 1.;
    for (unsigned int halvings = 0; halvings <= max_halvings;
         ++halvings, length *= 0.5)
      {
        const NewtonIteration state = try_step(length);
        if (!std::isfinite(residual_size(state)))
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
        if (!needs_decrease || before.prescribed > 0. ||
            decreases_enough(before, state))
          return state;
        if (!has_best || residual_size(state) < residual_size(best))
          best = state;
        has_best = true;
      }
    if (!has_best)
      throw NoConvergence("Newton", reason, FailureCause::inadmissible, place);
    return try_step(best.step_length);
  }
} // namespace stickslip
