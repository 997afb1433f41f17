#ifndef stickslip_strategy_step_control_h
#define stickslip_strategy_step_control_h

#include <stickslip/strategy/attempt.h>
#include <stickslip/strategy/back_off.h>
#include <stickslip/strategy/load_stepping.h>

#include <deque>
#include <optional>
#include <vector>

namespace stickslip
{
  /**
   * All that the control of load steps remembers from one accepted step to the
   * next; a run that continues at it makes the same decisions as one that was
   * never interrupted.
   */
  struct StepControlState
  {
    LoadSteppingState        load_stepping;
    unsigned int             first_level = 0; ///< in the fallback sequence
    unsigned int             stay_length = 0; ///< on an escalated level
    unsigned int             stay_left   = 0;
    std::deque<unsigned int> last_iterations; ///< Newton's, of the last steps

    /// Calls visit(name, member) for each number; last_iterations, of variable
    /// length, is not among them. @p State is this class, const or not.
    template <typename State, typename Visit>
    static void
    for_each_number(State &state, const Visit &visit)
    {
      visit("time", state.load_stepping.time);
      visit("step size", state.load_stepping.step_size);
      visit("step", state.load_stepping.step);
      visit("growth delay", state.load_stepping.growth_delay);
      visit("growth delay left", state.load_stepping.growth_delay_left);
      visit("step has grown", state.load_stepping.has_grown);
      visit("fallback level", state.first_level);
      visit("stay length", state.stay_length);
      visit("stay left", state.stay_left);
    }
  };



  /**
   * Newton iterations that an attempt may take. An attempt that takes more is
   * worse than its alternatives: two halves of the step (where it @p can_be_cut),
   * if it has taken three times the iterations of the costliest of the last
   * steps and at least a hundred; the next algorithm (where there
   * @p is_fallback), if it has taken ten times the iteration cap @p newton_cap
   * of one Newton solve, which is also what an algorithm without a next one may
   * take before a cut. Without alternative there is no budget.
   */
  unsigned int
  iteration_budget(const std::deque<unsigned int> &last_iterations,
                   const bool                      can_be_cut,
                   const bool                      is_fallback,
                   const unsigned int              newton_cap);



  /**
   * Decides how a run goes on from one accepted state to the next: how far the
   * load steps, with which algorithm, from which guess and with how many
   * iterations each step is attempted, what follows on a failed attempt. Knows
   * nothing of mechanics, solves nothing.
   *
   * Steps begin with the first algorithm of the fallback sequence. One that had
   * to be escalated to is where the next steps begin, for longer each time;
   * then the one before it is tried again.
   */
  class StepControl
  {
  public:
    /// @p sequence: the algorithms to try in a step, in this order;
    /// @p newton_cap: iterations of one Newton solve.
    StepControl(const LoadSteppingParameters &parameters,
                std::vector<Algorithm>        sequence,
                const unsigned int            newton_cap);

    /// Time, size and number of steps.
    const LoadStepping &
    steps() const
    {
      return load_stepping;
    }

    /// The next step begins: it has not been cut yet.
    void
    begin_step()
    {
      cuts = 0;
    }

    /// Cuts of the present step.
    unsigned int
    n_cuts() const
    {
      return cuts;
    }

    /// How a step, or what a cut has left of it, is attempted first.
    Attempt
    first_attempt() const;

    /// See stickslip::next_attempt().
    std::optional<Attempt>
    next_attempt(const Attempt     &failed,
                 const FailureCause cause,
                 const RetryEffect &effect) const;

    /// See LoadStepping::locate_contact_change().
    bool
    locate_contact_change(const bool contact_changes)
    {
      return load_stepping.locate_contact_change(contact_changes);
    }

    /// All attempts have failed. False if the next step would be below the
    /// minimum: the run has to end.
    bool
    cut_step();

    /// See LoadStepping::leap().
    bool
    leap()
    {
      return load_stepping.leap();
    }

    /// The attempt @p solved has solved the step in @p newton_iterations.
    void
    accept_step(const Attempt &solved, const unsigned int newton_iterations);

    /// What a checkpoint has to keep.
    StepControlState
    state() const;

    /// Continues at the state of an earlier run, as far as present parameters
    /// allow it.
    void
    resume(const StepControlState &state);

  private:
    const LoadSteppingParameters parameters;
    const std::vector<Algorithm> sequence;
    const unsigned int           newton_cap;
    LoadStepping                 load_stepping;
    unsigned int                 cuts        = 0; ///< of the present step
    unsigned int                 first_level = 0; ///< in sequence
    BackOff                      stay;            ///< on first_level
    std::deque<unsigned int>     last_iterations; ///< of the last steps

    /// Chooses the level of the next step after one solved at @p level.
    void
    choose_level(const unsigned int level);
  };
} // namespace stickslip

#endif
