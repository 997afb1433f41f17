#ifndef stickslip_strategy_load_stepping_h
#define stickslip_strategy_load_stepping_h

#include <stickslip/strategy/back_off.h>
#include <stickslip/strategy/load_stepping_parameters.h>

#include <string>

namespace stickslip
{
  /// What LoadStepping remembers from step to step.
  struct LoadSteppingState
  {
    double       time              = 0.;
    double       step_size         = 0.;
    unsigned int step              = 0; ///< number of accepted steps
    unsigned int growth_delay      = 0;
    unsigned int growth_delay_left = 0;
    bool         has_grown         = false; ///< after the last accepted step
  };



  /// What is known of a step in which contact is first made or lost: its size
  /// has been found too small or large enough for that.
  struct ContactChangeSearch
  {
    double without = 0.; ///< largest size in which nothing changes
    double with    = 0.; ///< smallest in which something does; 0: none
  };

  /**
   * The size that a step should have to end where contact changes, as far as
   * @p search knows: halves what is between its sizes until they differ by at
   * most @p tolerance; then the larger one. Where nothing changes, the size
   * without a change.
   */
  double
  size_up_to_change(const ContactChangeSearch &search, const double tolerance);



  /**
   * Chooses the sizes of the load steps from time 0 to the end: cuts a step
   * that failed, lets steps grow again after easy ones, and hits requested
   * times exactly.
   *
   * Without cuts each easy step lets the next one grow. After a cut, growth
   * waits for two easy steps in a row, and for twice as many each time that a
   * step fails again before a larger one has been accepted, at most eight.
   *
   * Where not even the smallest step can be solved there may be no state
   * nearby: a body snaps, or a point that carries load slides off an end. Then
   * larger steps from the same state may reach what comes after that: leaps.
   */
  class LoadStepping
  {
  public:
    explicit LoadStepping(const LoadSteppingParameters &parameters);

    bool
    finished() const;

    /// The time that the next step goes to.
    double
    next_time() const;

    /// The step to next_time() was solved with this many Newton iterations.
    void
    accept_step(const unsigned int newton_iterations);

    /**
     * The step to next_time() was solved, and contact has been made or lost in
     * it if @p contact_changes. True if the step is to be solved once more,
     * to what next_time() is now: changes are to be located, and this one is
     * not yet at its end.
     */
    bool
    locate_contact_change(const bool contact_changes);

    /// What a cut would leave of the step to next_time() is not below the
    /// minimum, or the step was shortened because contact changes in it.
    bool
    can_be_cut() const;

    /// The step to next_time() has failed: makes it smaller, or as large as it
    /// was before a change of contact was looked for, which is given up.
    /// Returns what can_be_cut() said before.
    bool
    cut_step();

    /**
     * The step to next_time() has failed and cannot be cut: makes it twice as
     * large as the largest one that has failed from this state, at most the
     * initial step, and less where a requested time is in its way. Where that
     * is no larger, or leaps are not wanted, the step is the smallest one again
     * and the result is false.
     */
    bool
    leap();

    /// The step to next_time() is larger than one from the same state that
    /// could not be cut.
    bool
    is_leaping() const
    {
      return smallest_failed > 0.;
    }

    /// The failed step in words, where it cannot be cut.
    std::string
    describe_last_step() const;

    /// What a user should know of a leap that was solved.
    std::string
    describe_leap() const;

    /// True where the load may change its direction: at a requested time.
    bool
    is_at_requested_time() const;

    double
    time() const
    {
      return current_time;
    }

    double
    step_size() const
    {
      return step;
    }

    /// Number of accepted steps.
    unsigned int
    step_number() const
    {
      return n_accepted;
    }

    LoadSteppingState
    state() const;

    /// Continues at a state of an earlier run.
    void
    resume(const LoadSteppingState &state);

  private:
    const LoadSteppingParameters parameters;
    double                       current_time = 0.;
    double                       step;
    unsigned int                 n_accepted = 0;
    BackOff                      growth_delay; ///< in easy steps in a row
    bool                         has_grown = false;

    // of the present step
    ContactChangeSearch search;
    double              shortened_to    = 0.; ///< 0: not shortened
    bool                search_is_over  = false;
    double              largest_failed  = 0.; ///< size
    double              smallest_failed = 0.; ///< where a leap began; 0: none

    /// As if there were no change of contact.
    double
    whole_next_time() const;

    /// Of the present step, to next_time().
    double
    present_size() const
    {
      return shortened_to > 0. ? shortened_to
                               : whole_next_time() - current_time;
    }

    void
    forget_search();

    /// An accepted step, or the end.
    void
    forget_failures()
    {
      largest_failed  = 0.;
      smallest_failed = 0.;
    }
  };
} // namespace stickslip

#endif
