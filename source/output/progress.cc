#include <stickslip/output/progress.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include <unistd.h>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    /// Six digits are enough for times on the screen.
    std::string
    short_number(const double value)
    {
      std::ostringstream text;
      text << std::setprecision(6) << value;
      return text.str();
    }
  } // namespace



  std::string
  duration_in_words(const double seconds)
  {
    const long total      = std::lround(seconds);
    const auto two_digits = [](const long n) {
      return (n < 10 ? "0" : "") + std::to_string(n);
    };
    if (total < 60)
      return std::to_string(total) + " s";
    if (total < 3600)
      return std::to_string(total / 60) + " min " + two_digits(total % 60) +
             " s";
    return std::to_string(total / 3600) + " h " +
           two_digits(total % 3600 / 60) + " min";
  }



  Progress::Progress(const Verbosity verbosity,
                     const double    start_time,
                     const double    end_time,
                     const MPI_Comm  communicator,
                     std::ostream   &out)
    : start_time(start_time)
    , end_time(end_time)
    , is_active(verbosity == Verbosity::progress &&
                Utilities::MPI::this_mpi_process(communicator) == 0)
    , shows_results(verbosity != Verbosity::quiet &&
                    Utilities::MPI::this_mpi_process(communicator) == 0)
    , is_terminal(&out == &std::cout && isatty(fileno(stdout)) == 1)
    , out(out)
    , start(Clock::now())
    , last(start)
    , last_time(start_time)
  {}



  void
  Progress::set_terminal(const bool is_terminal)
  {
    this->is_terminal = is_terminal;
  }



  void
  Progress::accepted_step(const unsigned int step,
                          const double       time,
                          const std::string &iterations)
  {
    if (!is_active)
      return;

    const std::string where =
      "Step " + std::to_string(step) + ", time " + short_number(time);
    if (is_terminal)
      {
        out << where << " of " << short_number(end_time) << ": " << iterations
            << ", " << time_left(time) << std::endl;
        return;
      }

    const double done = (time - start_time) / (end_time - start_time);
    if (done + 1e-10 < 0.1 * next_tenth)
      return;
    next_tenth = static_cast<unsigned int>(10. * (done + 1e-10)) + 1;
    out << where << " of " << short_number(end_time) << std::endl;
  }



  void
  Progress::rejected_step(const double       time,
                          const std::string &reason,
                          const double       step_size)
  {
    if (is_active)
      out << "  Step to time " << short_number(time) << " cut to "
          << short_number(step_size) << ": " << reason << std::endl;
  }



  void
  Progress::warn(const std::string &text)
  {
    if (is_active)
      out << "  Warning: " << text << std::endl;
  }



  void
  Progress::finished(const unsigned int n_steps)
  {
    if (!is_active)
      return;
    out << "Finished after " << n_steps << (n_steps == 1 ? " step" : " steps");
    if (is_terminal)
      out << " in "
          << duration_in_words(
               std::chrono::duration<double>(Clock::now() - start).count());
    out << '.' << std::endl;
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
