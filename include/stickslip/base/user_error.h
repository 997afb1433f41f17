#ifndef stickslip_base_user_error_h
#define stickslip_base_user_error_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * An input that cannot be run. The text names the parameter (as
   * "Section/Name"), what was found and what is allowed; main() prints it once
   * and every rank exits with status 1. Throw it on all ranks or on none.
   */
  class UserError : public std::runtime_error
  {
  public:
    explicit UserError(const std::string &text)
      : std::runtime_error(text)
    {}
  };



  /// The first (by rank) non-empty @p error, on all ranks; empty if all are.
  /// Collective.
  std::string
  first_error(const std::string &error, const MPI_Comm communicator);



  /**
   * Throws UserError with the first (by rank) non-empty @p error on all ranks;
   * does nothing if all are empty. Collective.
   */
  void
  throw_collectively(const std::string &error, const MPI_Comm communicator);

  /// Calls @p work on rank 0; a UserError that it throws is thrown on all ranks.
  /// Collective.
  void
  on_first_rank(const std::function<void()> &work, const MPI_Comm communicator);
} // namespace stickslip

#endif
