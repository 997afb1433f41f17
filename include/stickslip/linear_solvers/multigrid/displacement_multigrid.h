#ifndef stickslip_linear_solvers_multigrid_displacement_multigrid_h
#define stickslip_linear_solvers_multigrid_displacement_multigrid_h

#include <stickslip/base/block_system.h>

#include <stickslip/linear_solvers/multigrid/smoothed_aggregation.h>

namespace stickslip
{
  /**
   * One multigrid cycle for a matrix of displacements: algebraic multigrid by
   * smoothed aggregation with the near null space of the description. For
   * elements of a higher degree the second level is that of the linear ones
   * (Galerkin).
   */
  class DisplacementMultigrid
  {
  public:
    /**
     * Makes the hierarchy of the sum of @p matrix and @p added (which may have
     * no rows at all), and keeps copies of what it needs. Throws NoConvergence.
     * Collective.
     */
    void
    reinit(const LA::SparseMatrix       &matrix,
           const BlockRows<double>      &added,
           const BlockSystemDescription &description);

    void
    clear()
    {
      hierarchy.clear();
    }

    /// One cycle with a zero initial guess. Collective.
    void
    vmult(LA::Vector &x, const LA::Vector &b) const
    {
      hierarchy.vmult(x.begin(), b.begin());
    }

    /// The same for arrays of the entries that this rank owns.
    void
    vmult(double *x, const double *b) const
    {
      hierarchy.vmult(x, b);
    }

  private:
    SmoothedAggregation hierarchy;
  };
} // namespace stickslip

#endif
