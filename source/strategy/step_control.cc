#include <stickslip/strategy/step_control.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Most steps that an escalated algorithm is kept before the one before it
    /// in the sequence is tried again.
    constexpr unsigned int longest_stay = 16;

    /// Steps whose Newton iterations tell what a step costs.
    constexpr unsigned int n_remembered_steps = 3;

    /// An attempt that costs so many times as much as the costliest of them
    /// has cost more than two halves of the step would.
    constexpr unsigned int costly_factor = 3;

    /// As many iterations are always allowed before a cut: it is early to
    /// judge.
    constexpr unsigned int always_allowed = 100;

    /// Newton solves, at the cap of each, after which the next algorithm is
    /// worth trying. An algorithm that is the only one has as many before a
    /// cut: a halved step has other results, and who compares algorithms wants
    /// the same steps.
    constexpr unsigned int patient_solves = 10;
  } // namespace



  unsigned int
  iteration_budget(const std::deque<unsigned int> &last_iterations,
                   const bool                      can_be_cut,
                   const bool                      is_fallback,
                   const unsigned int              newton_cap)
  {
    const unsigned int patience = patient_solves * newton_cap;

    unsigned int budget = std::numeric_limits<unsigned int>::max();
    if (can_be_cut && !last_iterations.empty())
      budget =
        std::max(costly_factor * *std::max_element(last_iterations.begin(),
                                                   last_iterations.end()),
                 is_fallback ? always_allowed : patience);
    if (is_fallback)
      budget = std::min(budget, patience);
    return budget;
  }



  StepControl::StepControl(const LoadSteppingParameters &parameters,
                           std::vector<Algorithm>        sequence,
                           const unsigned int            newton_cap)
    : parameters(parameters)
    , sequence(std::move(sequence))
    , newton_cap(newton_cap)
    , load_stepping(parameters)
    , stay(1, longest_stay)
  {}



  Attempt
  StepControl::first_attempt() const
  {
    // What has failed once is tried without extrapolation, and at a requested
    // time the load may turn.
    const bool is_predicted = parameters.predictor == Predictor::linear &&
                              cuts == 0 &&
                              !load_stepping.is_at_requested_time();
    Attempt attempt;
    attempt.algorithm = sequence[first_level];
    attempt.guess =
      is_predicted ? Attempt::Guess::predicted : Attempt::Guess::accepted;
    // a leap is one of several
    attempt.step_can_be_cut =
      load_stepping.can_be_cut() || load_stepping.is_leaping();
    attempt.budget = iteration_budget(last_iterations,
                                      attempt.step_can_be_cut,
                                      sequence.size() > 1,
                                      newton_cap);
    return attempt;
  }



  std::optional<Attempt>
  StepControl::next_attempt(const Attempt     &failed,
                            const FailureCause cause,
                            const RetryEffect &effect) const
  {
    return stickslip::next_attempt(failed, cause, effect, sequence);
  }



  bool
  StepControl::cut_step()
  {
    ++cuts;
    return load_stepping.cut_step();
  }



  void
  StepControl::accept_step(const Attempt     &solved,
                           const unsigned int newton_iterations)
  {
    load_stepping.accept_step(newton_iterations);
    last_iterations.push_back(newton_iterations);
    if (last_iterations.size() > n_remembered_steps)
      last_iterations.pop_front();
    choose_level(std::find(sequence.begin(), sequence.end(), solved.algorithm) -
                 sequence.begin());
  }



  void
  StepControl::choose_level(const unsigned int level)
  {
    if (level > first_level)
      {
        first_level = level;
        stay.fail();
        return;
      }
    if (first_level == 0)
      {
        stay.succeed();
        return;
      }
    stay.advance();
    if (stay.is_waiting())
      return;
    --first_level;
    if (first_level > 0)
      stay.restart();
  }



  StepControlState
  StepControl::state() const
  {
    return {load_stepping.state(),
            first_level,
            stay.wait_length(),
            stay.steps_left(),
            last_iterations};
  }



  void
  StepControl::resume(const StepControlState &state)
  {
    load_stepping.resume(state.load_stepping);
    // the fallback sequence may be another one
    first_level = state.first_level < sequence.size() ? state.first_level : 0;
    stay.resume(state.stay_length, state.stay_left);
    last_iterations = state.last_iterations;
  }
} // namespace stickslip
