#ifndef stickslip_linear_solvers_multigrid_block_gauss_seidel_h
#define stickslip_linear_solvers_multigrid_block_gauss_seidel_h

#include <stickslip/linear_solvers/multigrid/block_diagonal.h>
#include <stickslip/linear_solvers/multigrid/ordered_exchange.h>

#include <vector>

namespace stickslip
{
  /**
   * Gauss-Seidel sweeps that solve for all unknowns of a cluster of nodes at
   * once, over all ranks. (Sweeps of each rank for itself took up to a fifth
   * more iterations on 4 ranks than on one.)
   *
   * A rank goes forwards over the clusters beside later ranks only, a share of
   * its inner clusters, those beside earlier and later ranks, the other inner
   * ones, those beside earlier ranks only. It receives and sends in the middle.
   * That share grows with its turn (see OrderedExchange), so that messages are
   * there when they are needed: all ranks work at the same time. Backwards
   * everything is the other way round.
   */
  class BlockGaussSeidel
  {
  public:
    /**
     * Takes the sweeps from @p A, the columns of which it sorts by their order;
     * @p A is not needed afterwards. Zero pivots (unknowns without stiffness)
     * give zero. Triangles are stored by themselves, in single precision, each
     * as its sweep reads it. (Linear solves took 1.4 times as long with
     * half-rows of one matrix.) Collective.
     */
    void
    reinit(BlockMatrix &A, NodeClusters &&clusters);

    /**
     * One sweep forwards and one backwards from x = 0, and the residual that is
     * left. With A = L + D + U the sweeps are (D + L) x1 = b and (D + U) x =
     * b - L x1, and b - A x = L (x1 - x): no part of A is needed twice.
     * Collective.
     */
    void
    solve(std::vector<double>       &x,
          std::vector<double>       &residual,
          const std::vector<double> &b) const;

    /// One sweep forwards and one backwards from the given x. Collective.
    void
    smooth(std::vector<double> &x, const std::vector<double> &b) const;

    const NodeClusters &
    node_clusters() const
    {
      return clusters;
    }

    /// y = D^-1 y in the unknowns of a cluster.
    void
    scale(const unsigned int cluster, double *y) const;

    /// The largest eigenvalue of D^-1 A, from below, by some steps of the power
    /// method. Collective.
    double
    largest_eigenvalue() const;

  private:
    NodeSpace                 space;
    NodeClusters              clusters;
    CycleMatrix               lower, upper; ///< without the diagonal blocks
    OrderedExchange           exchange;
    std::vector<unsigned int> order; ///< of the clusters
    /// Where in it those are that are beside earlier and later ranks.
    unsigned int  middle_begin = 0, middle_end = 0;
    BlockDiagonal diagonal;

    mutable std::vector<double> lower_residual;  ///< b - L x1
    mutable std::vector<double> upper_part;      ///< U x
    mutable std::vector<double> defect, product; ///< of one cluster

    void
    set_order(const BlockMatrix &A);

    void
    copy_triangles(const BlockMatrix &A);

    /// The clusters [first, end) of the order, while messages get on.
    template <typename Visitor>
    void
    visit_forwards(const unsigned int first,
                   const unsigned int end,
                   const Visitor     &visit) const;

    template <typename Visitor>
    void
    visit_backwards(const unsigned int first,
                    const unsigned int end,
                    const Visitor     &visit) const;

    /// (D + L) x1 = b - @p upper_part, which leaves lower_residual. nullptr
    /// is zero.
    void
    sweep_forwards(std::vector<double>       &x,
                   const std::vector<double> &b,
                   const double              *upper_part) const;

    /// (D + U) x = lower_residual; later ranks have their turn first.
    void
    sweep_backwards(std::vector<double> &x) const;

    /// x = D^-1 defect in one cluster.
    void
    set_from_defect(const unsigned int cluster, std::vector<double> &x) const;
  };
} // namespace stickslip

#endif
