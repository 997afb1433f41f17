#include <stickslip/simulation/run_files.h>

#include <stickslip/base/command_line.h>
#include <stickslip/base/user_error.h>

#include <stickslip/output/old_output.h>
#include <stickslip/output/output_directory.h>

#include <stickslip/simulation/checkpoint_directory.h>

namespace stickslip
{
  namespace
  {
    /// The first line of parameters.prm, which scripts/report reads.
    std::string
    version_and_ranks(const MPI_Comm &communicator)
    {
      const std::string  version = version_text();
      const unsigned int n = Utilities::MPI::n_mpi_processes(communicator);
      return "# " + version.substr(0, version.find('\n')) + ", " +
             std::to_string(n) + (n == 1 ? " rank" : " ranks") + "\n";
    }



    /// On rank 0. Returns what went wrong.
    std::string
    retire_earlier_run(const std::string &directory, const RunStart &start)
    {
      if (start.goes_on)
        {
          const std::string error =
            make_latest_checkpoint(start.checkpoint, directory);
          return error.empty() ? remove_output_after(directory, start.step)
                               : error;
        }
      retire_checkpoints(directory);
      return remove_old_output(directory);
    }
  } // namespace



  RunStart
  find_run_start(const CaseParameters &parameters,
                 const std::string    &restart_from,
                 const MPI_Comm       &communicator)
  {
    const std::string &directory = parameters.output.directory;
    RunStart           start;
    start.checkpoint = restart_from == "latest" ? directory : restart_from;
    start.goes_on    = !start.checkpoint.empty() &&
                    checkpoint_is_in(start.checkpoint, directory, communicator);
    return start;
  }



  void
  prepare_run_files(const CaseParameters &parameters,
                    const RunStart       &start,
                    const MPI_Comm       &communicator)
  {
    const std::string &directory = parameters.output.directory;
    std::string        error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        error = retire_earlier_run(directory, start);
        if (error.empty())
          error = write_file_atomically(directory + "/parameters.prm",
                                        version_and_ranks(communicator) +
                                          parameters.record);
      }
    throw_collectively(error, communicator);
  }
} // namespace stickslip
