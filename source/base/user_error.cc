#include <stickslip/base/user_error.h>

namespace stickslip
{
  void
  throw_collectively(const std::string &error, const MPI_Comm communicator)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int first =
      Utilities::MPI::min(error.empty() ? n_ranks : rank, communicator);
    if (first < n_ranks)
      throw UserError(Utilities::MPI::broadcast(communicator, error, first));
  }
} // namespace stickslip
