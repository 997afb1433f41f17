#ifndef stickslip_base_rank_ranges_h
#define stickslip_base_rank_ranges_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <vector>

namespace stickslip
{
  /// Numbers that are distributed over the ranks, an interval on each.
  class RankRanges
  {
  public:
    using Index = dealii::types::global_dof_index;

    RankRanges() = default;

    /// @p n_owned: how many numbers this rank has. Collective.
    RankRanges(const Index n_owned, const MPI_Comm &communicator);

    /// Numbers of all ranks; none if it is only declared.
    Index
    n_global() const
    {
      return begins.empty() ? 0 : begins.back();
    }

    Index
    begin(const unsigned int rank) const
    {
      return begins[rank];
    }

    unsigned int
    rank_of(const Index index) const;

  private:
    std::vector<Index> begins; ///< by rank, and at last the number of all
  };
} // namespace stickslip

#endif
