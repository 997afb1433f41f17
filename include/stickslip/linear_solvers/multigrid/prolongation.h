#ifndef stickslip_linear_solvers_multigrid_prolongation_h
#define stickslip_linear_solvers_multigrid_prolongation_h

#include <stickslip/linear_solvers/multigrid/cycle_matrix.h>

#include <vector>

namespace stickslip
{
  /// What leads from a level of the multigrid to the finer one, and back.
  class Prolongation
  {
  public:
    Prolongation() = default;

    /// Takes the values of @p rows, one for each node of the @p fine level that
    /// this rank owns. Collective.
    Prolongation(BlockRows<float> &&rows,
                 const NodeSpace   &fine,
                 const NodeSpace   &coarse);

    /// That of vectors of the coarse level.
    const NodeSpace &
    coarse_space() const
    {
      return coarse;
    }

    /// fine += P coarse, whose ghosts are fetched first. Collective.
    void
    add_to_fine(std::vector<double> &fine, std::vector<double> &coarse) const;

    /// coarse = P^T fine, summed up over the ranks. Collective.
    void
    restrict_to_coarse(std::vector<double>       &coarse,
                       const std::vector<double> &fine) const;

  private:
    NodeSpace                 coarse;
    std::vector<unsigned int> row_begins;
    CycleMatrix               matrix;
  };
} // namespace stickslip

#endif
