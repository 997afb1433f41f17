#include <stickslip/strategy/algorithm_ladder.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Most steps that a climbed rung is kept before the one below is tried.
    constexpr unsigned int longest_stay = 16;



    /// Another algorithm may help where the unknown statuses, thresholds and
    /// pairings are the trouble, not where the step is too large for the bodies
    /// or nothing holds them.
    bool
    another_algorithm_may_help(const FailureCause cause)
    {
      return cause == FailureCause::cycle ||
             cause == FailureCause::stagnation ||
             cause == FailureCause::loop_limit ||
             cause == FailureCause::rejected;
    }
  } // namespace



  AlgorithmLadder::AlgorithmLadder(const std::string &name)
    : rungs(name == "automatic" ? std::vector<std::string>{"GNM", "PNM", "FPM"}
                                : std::vector<std::string>{name})
  {}



  void
  AlgorithmLadder::begin_step()
  {
    rung = first_rung;
  }



  bool
  AlgorithmLadder::climb(const NoConvergence &failure)
  {
    if (rung + 1 == rungs.size() || !another_algorithm_may_help(failure.cause))
      return false;
    ++rung;
    return true;
  }



  void
  AlgorithmLadder::accept_step()
  {
    if (rung > first_rung)
      {
        first_rung = rung;
        n_stay     = patience;
        patience   = std::min(2 * patience, longest_stay);
      }
    else if (first_rung > 0 && --n_stay == 0)
      {
        --first_rung;
        n_stay = patience;
      }
    else if (first_rung == 0)
      patience = std::max(patience - 1, 1U);
  }
} // namespace stickslip
