#include <stickslip/base/user_error.h>

namespace stickslip
{
  std::string
  first_error(const std::string &error, const MPI_Comm communicator)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int first =
      Utilities::MPI::min(error.empty() ? n_ranks : rank, communicator);
    return first < n_ranks
             ? Utilities::MPI::broadcast(communicator, error, first)
             : "";
  }



  void
  throw_collectively(const std::string &error, const MPI_Comm communicator)
  {
    const std::string text = first_error(error, communicator);
    if (!text.empty())
      throw UserError(text);
  }
} // namespace stickslip
