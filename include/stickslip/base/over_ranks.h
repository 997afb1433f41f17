#ifndef stickslip_base_over_ranks_h
#define stickslip_base_over_ranks_h

#include <deal.II/base/mpi.h>

namespace stickslip
{
  /// True on all ranks if @p condition is true on any of them. Collective.
  inline bool
  any_rank(const bool condition, const MPI_Comm &communicator)
  {
    return dealii::Utilities::MPI::max(condition ? 1 : 0, communicator) == 1;
  }



  /// True on all ranks if @p condition is true on each of them. Collective.
  inline bool
  all_ranks(const bool condition, const MPI_Comm &communicator)
  {
    return dealii::Utilities::MPI::min(condition ? 1 : 0, communicator) == 1;
  }
} // namespace stickslip

#endif
