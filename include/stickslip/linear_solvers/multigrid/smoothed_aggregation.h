#ifndef stickslip_linear_solvers_multigrid_smoothed_aggregation_h
#define stickslip_linear_solvers_multigrid_smoothed_aggregation_h

#include <stickslip/base/types.h>

#include <stickslip/linear_solvers/factorization/distributed_factorization.h>
#include <stickslip/linear_solvers/multigrid/aggregation.h>
#include <stickslip/linear_solvers/multigrid/block_gauss_seidel.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Algebraic multigrid by smoothed aggregation: V-cycles with a symmetric
   * Gauss-Seidel sweep before and after, a direct solver on the coarsest level.
   * A coarse node has as many unknowns as there are independent modes in its
   * aggregate, which is what makes it smaller than libraries with one number
   * for all. Holds copies of all it needs.
   */
  class SmoothedAggregation
  {
  public:
    SmoothedAggregation();

    /**
     * Makes the hierarchy of @p matrix. If @p prolongation has rows, they are
     * that to the second level, whose nodes are @p second; @p modes are those
     * of the first level that is coarsened by aggregation. Throws ExceptionBase
     * if the coarsest matrix cannot be factorised. Collective.
     */
    void
    reinit(BlockMatrix<double> &&matrix,
           BlockRows<float>    &&prolongation,
           const NodeSpace      &second,
           Modes               &&modes);

    void
    clear();

    /// One cycle with a zero initial guess. Throws NoConvergence if the solve
    /// on the coarsest level fails. Collective.
    void
    vmult(LA::Vector &x, const LA::Vector &b) const;

    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    /// Unknowns of a level, over all ranks.
    types::global_dof_index
    n_unknowns(const unsigned int level) const;

    /// Bytes of the matrices on this rank.
    std::size_t
    memory_consumption() const;

  private:
    struct Level
    {
      BlockMatrix<double> matrix;
      BlockGaussSeidel    smoother;
      BlockMatrix<float>  prolongation; ///< from the next level
      /// x has ghosts, coarse is for the prolongation
      mutable std::vector<double> x, b, defect, coarse;
    };

    std::vector<std::unique_ptr<Level>> levels;
    LA::SparseMatrix                    coarsest_matrix;
    DistributedFactorization            coarsest_factors;
    mutable LA::Vector                  coarsest_x, coarsest_b;

    /// Adds the level above the present coarsest one.
    void
    coarsen(BlockRows<float> &&prolongation, const NodeSpace &coarse);

    void
    factorise_coarsest();

    /// x of the level from its b.
    void
    cycle(const unsigned int level) const;

    void
    solve_coarsest() const;
  };
} // namespace stickslip

#endif
