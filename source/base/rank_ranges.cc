#include <stickslip/base/rank_ranges.h>

#include <algorithm>

namespace stickslip
{
  RankRanges::RankRanges(const Index n_owned, const MPI_Comm &communicator)
    : begins(1, 0)
  {
    for (const Index n :
         dealii::Utilities::MPI::all_gather(communicator, n_owned))
      begins.push_back(begins.back() + n);
  }



  unsigned int
  RankRanges::rank_of(const Index index) const
  {
    return std::upper_bound(begins.begin(), begins.end(), index) -
           begins.begin() - 1;
  }
} // namespace stickslip
