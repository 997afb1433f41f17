#ifndef stickslip_output_progress_h
#define stickslip_output_progress_h

#include <stickslip/output/output_parameters.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <iostream>
#include <string>

namespace stickslip
{
  /**
   * Tells on the screen how far a run is, with Verbosity::progress: a line per
   * step with what it took and an estimate of the time left, the same on a
   * terminal and in the log of a batch system, and the rejected steps. Only
   * rank 0 speaks. Not collective.
   */
  class Progress
  {
  public:
    Progress(const Verbosity verbosity,
             const double    start_time,
             const double    end_time,
             const MPI_Comm  communicator,
             std::ostream   &out = std::cout);

    /// The run goes on from @p time, which it has not spent time on.
    void
    resume(const double time);

    /**
     * A step to @p time was accepted; @p iterations in words, for example
     * "GNM, 6 Newton iterations, 214 points closed".
     */
    void
    accepted_step(const unsigned int step,
                  const double       time,
                  const std::string &iterations);

    /// A step to @p time failed because of @p reason; the next has @p step_size.
    void
    rejected_step(const double       time,
                  const std::string &reason,
                  const double       step_size);

    /// Something that looks wrong although the run goes on.
    void
    warn(const std::string &text);

    /// A line about the run.
    void
    say(const std::string &text);

    /// The run is complete after @p n_steps steps.
    void
    finished(const unsigned int n_steps);

    /// True on rank 0 unless the verbosity is quiet.
    bool
    prints_results() const
    {
      return shows_results;
    }

  private:
    using Clock = std::chrono::steady_clock;

    std::string
    time_left(const double time);

    const double  end_time;
    const bool    is_active;
    const bool    shows_results;
    std::ostream &out;

    const Clock::time_point start;
    Clock::time_point       last;
    double                  last_time;
    /// Wall seconds per simulated time, mean over the latest steps.
    double pace = 0.;
  };
} // namespace stickslip

#endif
