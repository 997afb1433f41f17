#include <stickslip/base/stop_requests.h>

#include <stickslip/base/duration.h>

#include <chrono>
#include <csignal>

namespace stickslip
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    const Clock::time_point start_of_program = Clock::now();

    /// The last signal that asked for an end; 0: none.
    volatile std::sig_atomic_t caught_signal = 0;

    /// Reasons as numbers, for a reduction over the ranks; a signal is its
    /// number after them.
    constexpr int no_reason = 0, time_is_up = 1, first_signal = 2;



    extern "C" void
    record_signal(const int number)
    {
      caught_signal = number;
    }



    std::string
    name_of_signal(const int number)
    {
      switch (number)
        {
          case SIGTERM:
            return "SIGTERM";
          case SIGUSR1:
            return "SIGUSR1";
          default:
            return "signal " + std::to_string(number);
        }
    }
  } // namespace



  void
  catch_stop_signals()
  {
    struct sigaction action = {};
    action.sa_handler       = record_signal;
    action.sa_flags         = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int number : {SIGTERM, SIGUSR1})
      sigaction(number, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN);
  }



  StopRequests::StopRequests(const std::optional<double> time_limit,
                             const MPI_Comm             &communicator)
    : time_limit(time_limit)
    , communicator(communicator)
  {}



  void
  StopRequests::check() const
  {
    if (is_delayed)
      return;
    const std::chrono::duration<double> used = Clock::now() - start_of_program;

    int reason = no_reason;
    if (caught_signal != 0)
      reason = first_signal + caught_signal;
    else if (time_limit && used.count() >= *time_limit)
      reason = time_is_up;
    reason = Utilities::MPI::max(reason, communicator);

    if (reason == time_is_up)
      throw RunStopped("the time of 'Output/Stop after' (" +
                       duration_in_words(*time_limit) + ") is used up");
    if (reason != no_reason)
      throw RunStopped(name_of_signal(reason - first_signal) + " has come");
  }
} // namespace stickslip
