#include <stickslip/strategy/attempt.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    bool
    another_algorithm_may_help(const FailureCause cause,
                               const bool         step_can_be_cut,
                               const bool         is_first)
    {
      switch (cause)
        {
          case FailureCause::cycle:
          case FailureCause::stagnation:
          case FailureCause::loop_limit:
          case FailureCause::loop_cycle:
          case FailureCause::budget:
          case FailureCause::rejected:
            return true;
          case FailureCause::divergence:
          case FailureCause::inadmissible:
            return !step_can_be_cut;
          // An iterate may let a body go, in steps of any size. A body that
          // nothing holds is let go by all of them: the next one is enough.
          case FailureCause::singular:
            return is_first;
          case FailureCause::linear_solver:
            return false;
        }
      return false;
    }



    bool
    is_retry(const Attempt &attempt)
    {
      return attempt.scales == Attempt::Scales::automatic;
    }
  } // namespace



  std::optional<Attempt>
  next_attempt(const Attempt                &failed,
               const FailureCause            cause,
               const RetryEffect            &effect,
               const std::vector<Algorithm> &sequence)
  {
    Attempt next = failed;
    next.pairing = Attempt::Pairing::hysteresis;
    if (!is_retry(failed) && (effect.scales || effect.pairing))
      {
        next.scales = Attempt::Scales::automatic;
        return next;
      }
    const auto present =
      std::find(sequence.begin(), sequence.end(), failed.algorithm);
    if (!another_algorithm_may_help(cause,
                                    failed.step_can_be_cut,
                                    present == sequence.begin()) ||
        present == sequence.end() || present + 1 == sequence.end())
      return {};
    next.algorithm = *(present + 1);
    next.guess     = Attempt::Guess::accepted;
    next.scales    = Attempt::Scales::as_adapted;
    return next;
  }



  std::string
  describe_change(const Attempt &failed, const Attempt &next)
  {
    std::string text = "next attempt: " + name_of(next.algorithm);
    if (next.guess != failed.guess)
      text += ", from the accepted state";
    if (next.scales == Attempt::Scales::automatic)
      text += ", automatic r";
    if (next.pairing != failed.pairing)
      text += ", pairing with hysteresis";
    return text;
  }
} // namespace stickslip
