#ifndef stickslip_strategy_load_stepping_h
#define stickslip_strategy_load_stepping_h

#include <stickslip/base/choice.h>

#include <stickslip/strategy/back_off.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Where Newton starts in a step.
  enum class Predictor
  {
    linear, ///< the displacements go on as in the last step
    none    ///< the accepted state
  };

  const Choices<Predictor> &
  all_predictors();



  /// The section "Load stepping".
  struct LoadSteppingParameters
  {
    double              end_time        = 1.;
    double              initial_step    = 1.;
    double              minimum_step    = 0.;
    double              maximum_step    = 0.;
    double              cut_factor      = 0.5;
    double              growth_factor   = 1.5;
    unsigned int        easy_iterations = 12;
    Predictor           predictor       = Predictor::linear;
    std::vector<double> requested_times;
    double              stabilization_factor     = 0.;
    bool                locates_contact_changes  = false;
    double              contact_change_tolerance = 1e-3; ///< of initial_step

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// Steps have to end at those of @p times that lie between 0 and the end.
    void
    request(const std::vector<double> &times);
  };



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

    /// The failed step in words, where it cannot be cut.
    std::string
    describe_last_step() const;

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
    double              shortened_to   = 0.; ///< 0: not shortened
    bool                search_is_over = false;

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
  };
} // namespace stickslip

#endif
