#ifndef stickslip_simulation_convergence_log_h
#define stickslip_simulation_convergence_log_h

#include <stickslip/contact/cycling/status_cycle_treatment.h>

#include <stickslip/strategy/newton_problem.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The file convergence.log in the output directory: every Newton iteration
   * and every fixed-point pass of every step, also of those that failed. Only
   * rank 0 writes.
   */
  class ConvergenceLog
  {
  public:
    ConvergenceLog(const std::string &directory, const MPI_Comm &communicator);

    /// Opens the file, to go on in it after a restart or to begin anew.
    void
    open(const bool go_on);

    void
    begin_step(const unsigned int step, const double time, const double size);

    void
    newton_iteration(const unsigned int     iteration,
                     const NewtonIteration &state);

    void
    loop_pass(const std::string &quantity,
              const unsigned int pass,
              const double       change,
              const unsigned int depth);

    void
    cycle_treatment(const CycleReport &report);

    /// The contact law has other corners now (LawContinuation).
    void
    rounding(const LawRounding &width);

    /// The iterations of the last Newton run, on all ranks.
    const std::vector<NewtonIteration> &
    last_newton_run() const
    {
      return last_run;
    }

    /// Free text, for example why a step failed.
    void
    note(const std::string &text);

  private:
    std::string                  name; ///< empty except on rank 0
    std::ofstream                file; ///< open on rank 0 only
    std::vector<NewtonIteration> last_run;
  };
} // namespace stickslip

#endif
