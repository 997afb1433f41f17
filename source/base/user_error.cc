#include <stickslip/base/user_error.h>

#include <functional>

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



  void
  on_first_rank(const std::function<void()> &work, const MPI_Comm communicator)
  {
    std::string error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          work();
        }
      catch (const UserError &exception)
        {
          error = exception.what();
        }
    throw_collectively(error, communicator);
  }
} // namespace stickslip
