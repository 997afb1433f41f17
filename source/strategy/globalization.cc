#include <stickslip/strategy/globalization.h>

#include <limits>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Full steps of a look ahead.
    constexpr unsigned int longest_look_ahead = 8;
  } // namespace



  Globalization::Globalization(const NewtonParameters &parameters,
                               NewtonProblem          &problem)
    : parameters(parameters)
    , problem(problem)
    , criterion(parameters)
  {}



  void
  Globalization::restart()
  {
    reference.restart();
    alternative.reset();
    may_look_ahead = true;
  }



  NewtonIteration
  Globalization::advance(const NewtonIteration &before,
                         const LA::BlockVector &increment,
                         LA::BlockVector       &x)
  {
    if (alternative)
      return look_ahead(before, increment, x);
    reference.add(before);
    LA::BlockVector        full_step(x);
    const LineSearchResult found =
      stickslip::advance(problem,
                         increment,
                         parameters.line_search == LineSearch::none
                           ? std::numeric_limits<double>::infinity()
                           : reference.value(),
                         criterion,
                         parameters.max_halvings,
                         x);
    if (found.is_good || found.state.step_length == 1. || !may_look_ahead ||
        !found.full_step_is_admissible)
      return found.state;
    alternative =
      Alternative{x, found.state.merit, found.state.step_length, 1, 0., false};
    full_step += increment;
    x = full_step;
    return state_at(problem, 1., x);
  }



  NewtonIteration
  Globalization::look_ahead(const NewtonIteration &before,
                            const LA::BlockVector &increment,
                            LA::BlockVector       &x)
  {
    x += increment;
    const NewtonIteration state = state_at(problem, 1., x);
    std::string           reason;
    if (is_finite(state) && problem.is_admissible(reason))
      {
        if (state.merit < alternative->merit)
          {
            alternative.reset();
            return state;
          }
        const bool grows = state.merit >= before.merit;
        const bool may_go_on =
          !grows ||
          (!alternative->has_grown && state.merit < alternative->last_merit);
        alternative->has_grown |= grows;
        alternative->last_merit = before.merit;
        if (may_go_on && ++alternative->steps_ahead < longest_look_ahead)
          return state;
      }
    const Alternative back = *alternative;
    alternative.reset();
    may_look_ahead = false;
    x              = back.x;
    return state_at(problem, back.step_length, x);
  }
} // namespace stickslip
