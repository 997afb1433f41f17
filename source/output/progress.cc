#include <stickslip/output/progress.h>

#include <stickslip/base/duration.h>
#include <stickslip/base/short_number.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  using namespace dealii;

  Progress::Progress(const Verbosity verbosity,
                     const double    start_time,
                     const double    end_time,
                     const MPI_Comm  communicator,
                     std::ostream   &out)
    : end_time(end_time)
    , is_active(verbosity == Verbosity::progress &&
                Utilities::MPI::this_mpi_process(communicator) == 0)
    , shows_results(verbosity != Verbosity::quiet &&
                    Utilities::MPI::this_mpi_process(communicator) == 0)
    , out(out)
    , start(Clock::now())
    , last(start)
    , last_time(start_time)
  {}



  void
  Progress::resume(const double time)
  {
    last      = Clock::now();
    last_time = time;
  }



  void
  Progress::accepted_step(const unsigned int step,
                          const double       time,
                          const std::string &iterations)
  {
    if (!is_active)
      return;

    out << "Step " << step << ", time " << short_number(time) << " of "
        << short_number(end_time) << ": " << iterations << ", "
        << time_left(time) << std::endl;
  }



  void
  Progress::rejected_step(const double       time,
                          const std::string &reason,
                          const double       step_size)
  {
    if (is_active)
      out << "  Step to time " << short_number(time) << " failed, next size "
          << short_number(step_size) << ": " << reason << std::endl;
  }



  void
  Progress::warn(const std::string &text)
  {
    if (is_active)
      out << "  Warning: " << text << std::endl;
  }



  void
  Progress::say(const std::string &text)
  {
    if (is_active)
      out << text << std::endl;
  }



  void
  Progress::finished(const unsigned int n_steps)
  {
    if (!is_active)
      return;
    out << "Finished after " << n_steps << (n_steps == 1 ? " step" : " steps")
        << " in "
        << duration_in_words(
             std::chrono::duration<double>(Clock::now() - start).count())
        << '.' << std::endl;
  }



  std::string
  Progress::time_left(const double time)
  {
    // Steps differ much (sizes, iterations): let the latest count most, but
    // not alone.
    const Clock::time_point now = Clock::now();
    const double            latest_pace =
      std::chrono::duration<double>(now - last).count() /
      std::max(time - last_time, 1e-300);
    pace = pace == 0. ? latest_pace : 0.7 * pace + 0.3 * latest_pace;

    last      = now;
    last_time = time;

    const double simulated_time_left = std::max(end_time - time, 0.);
    if (simulated_time_left <= 1e-12 * std::abs(end_time))
      return "done";
    return "about " + duration_in_words(pace * simulated_time_left) + " left";
  }
} // namespace stickslip
