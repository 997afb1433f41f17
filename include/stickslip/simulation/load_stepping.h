#ifndef stickslip_simulation_load_stepping_h
#define stickslip_simulation_load_stepping_h

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/parameter_handler.h>

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
  };
} // namespace stickslip

#endif
