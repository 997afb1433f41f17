#ifndef stickslip_simulation_load_stepping_h
#define stickslip_simulation_load_stepping_h

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/parameter_handler.h>

#include <deque>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  struct LoadSteppingParameters
  {
    double              end_time        = 1.;
    double              initial_step    = 1.;
    double              minimum_step    = 0.;
    double              maximum_step    = 0.;
    double              cut_factor      = 0.5;
    double              growth_factor   = 1.5;
    unsigned int        easy_iterations = 12;
    std::string         predictor       = "linear";
    std::vector<double> requested_times;
    double              stabilization_factor = 0.;

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;
  };



  /**
   * Chooses the load steps from time 0 to the end: cuts a step that failed,
   * lets steps grow again after easy ones, and hits requested times exactly.
   *
   * After a cut, growth waits for two easy steps; for twice as many each time
   * that a step fails again before a larger one has been accepted, at most
   * eight. A run that continues another one starts without such a memory.
   */
  class LoadStepping
  {
  public:
    explicit LoadStepping(const LoadSteppingParameters &parameters);

    bool
    finished() const;

    /// The time that the next step goes to.
    double
    propose_step();

    /**
     * Newton iterations after which cutting the step is cheaper than going on:
     * three times those of the costliest of the last three steps, at least 100.
     * Without limit in the first step, and where the cut step would be below
     * the minimum.
     */
    unsigned int
    iteration_limit() const;

    /// The proposed step was solved with this many Newton iterations.
    void
    accept_step(const unsigned int newton_iterations);

    /// Makes the next step smaller. Throws NoConvergence with the reason of
    /// @p failure when it would be below the minimum.
    void
    cut_step(const NoConvergence &failure);

    /// Continues at a state of an earlier run.
    void
    resume(const double time, const double step_size, const unsigned int step);

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

    unsigned int
    step_number() const
    {
      return n_accepted;
    }

  private:
    const LoadSteppingParameters parameters;
    double                       current_time  = 0.;
    double                       proposed_time = 0.;
    double                       step;
    unsigned int                 n_accepted = 0;

    std::deque<unsigned int> last_iterations; ///< of the last steps
    unsigned int n_easy    = 0; ///< easy steps in a row since the step changed
    unsigned int patience  = 1; ///< as many let it grow
    bool         has_grown = false; ///< after the last accepted step

    bool
    can_be_cut() const;
  };
} // namespace stickslip

#endif
