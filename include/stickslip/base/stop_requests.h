#ifndef stickslip_base_stop_requests_h
#define stickslip_base_stop_requests_h

#include <deal.II/base/mpi.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * The run should end before its end time: a signal has come or its
   * wall-clock time is used up. The text says which. Thrown by all ranks or by
   * none; nothing between the thrower and Simulation::run() catches it.
   */
  class RunStopped : public std::runtime_error
  {
  public:
    explicit RunStopped(const std::string &text)
      : std::runtime_error(text)
    {}
  };



  /**
   * From now on SIGTERM and SIGUSR1 do not end this process but are recorded
   * for StopRequests, and a file that grows beyond the limit of the system is
   * an error of writing (SIGXFSZ is ignored). Not collective. Call it after
   * MPI_Init, which has handlers of its own.
   */
  void
  catch_stop_signals();



  /// Asks whether somebody wants the run to end.
  class StopRequests
  {
  public:
    /// @p time_limit: wall-clock seconds since the program's start on this
    /// rank; none: no limit.
    StopRequests(const std::optional<double> time_limit,
                 const MPI_Comm             &communicator);

    /**
     * Throws RunStopped on all ranks if a signal has reached any of them, or
     * the time of any of them is up. Collective: one reduction of a number.
     */
    void
    check() const;

    /// While it lives, check() lets the run go on: what is under way would have
    /// to be done anew.
    class Delay
    {
    public:
      explicit Delay(StopRequests &requests)
        : requests(requests)
      {
        requests.is_delayed = true;
      }

      ~Delay()
      {
        requests.is_delayed = false;
      }

      Delay(const Delay &) = delete;
      Delay &
      operator=(const Delay &) = delete;

    private:
      StopRequests &requests;
    };

  private:
    bool                        is_delayed = false;
    const std::optional<double> time_limit;
    const MPI_Comm              communicator;
  };
} // namespace stickslip

#endif
