#ifndef stickslip_linear_solvers_multigrid_smoothed_aggregation_h
#define stickslip_linear_solvers_multigrid_smoothed_aggregation_h

#include <stickslip/base/types.h>

#include <stickslip/linear_solvers/factorization/root_factorization.h>
#include <stickslip/linear_solvers/multigrid/aggregation.h>
#include <stickslip/linear_solvers/multigrid/block_gauss_seidel.h>
#include <stickslip/linear_solvers/multigrid/prolongation.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Algebraic multigrid by smoothed aggregation: V-cycles with a symmetric
   * Gauss-Seidel sweep before and after, a direct solver on the coarsest level.
   * A coarse node has as many unknowns as there are independent modes in its
   * aggregate, which is what makes it smaller than libraries with one number
   * for all. Levels with few unknowns on each rank move to fewer ranks, so that
   * the coarsest one does not grow with the ranks. Holds copies of all it
   * needs; the matrices of the cycle are in single precision, those that
   * coarser ones are made of in double precision: a body on weak springs would
   * lose its rigid motions otherwise.
   */
  class SmoothedAggregation
  {
  public:
    /**
     * Makes the hierarchy of @p matrix, whose nodes have the given @p places.
     * If @p second has nodes, they are those of the second level, to which
     * @p prolongation leads; @p modes are those of the first level that is
     * coarsened by aggregation. Throws ExceptionBase
     * if the coarsest matrix cannot be factorised. Collective.
     */
    void
    reinit(BlockMatrix      &&matrix,
           BlockRows<float> &&prolongation,
           NodeSpace        &&second,
           const NodePlaces  &places,
           Modes            &&modes);

    void
    clear();

    /// One cycle with a zero initial guess, for arrays of the entries that this
    /// rank owns. Collective.
    void
    vmult(double *x, const double *b) const;

    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    /// Unknowns of a level, over all ranks.
    types::global_dof_index
    n_unknowns(const unsigned int level) const;

    /// Ranks that have unknowns of a level. The others wait for none of its
    /// messages in a cycle.
    unsigned int
    n_ranks(const unsigned int level) const;

  private:
    struct Level
    {
      NodeSpace        space;
      BlockGaussSeidel smoother;
      Prolongation     prolongation; ///< from the next level
      /// x has ghosts, coarse is for the prolongation
      mutable std::vector<double> x, b, defect, coarse;
    };

    std::vector<std::unique_ptr<Level>> levels;
    RootFactorization                   coarsest_factors;

    /// Adds the coarsest level so far, whose smoother sorts @p A.
    void
    add_level(BlockMatrix &A, const NodePlaces &places);

    /// Adds the next level to that of @p A, which becomes the matrix of that
    /// level.
    void
    coarsen(BlockMatrix       &A,
            BlockRows<float> &&prolongation,
            const NodeSpace   &coarse,
            const NodePlaces  &places);

    void
    factorise_coarsest(const BlockMatrix &A);

    /// x of the level from its b.
    void
    cycle(const unsigned int level) const;
  };
} // namespace stickslip

#endif
