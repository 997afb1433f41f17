#ifndef stickslip_linear_solvers_multigrid_block_diagonal_h
#define stickslip_linear_solvers_multigrid_block_diagonal_h

#include <stickslip/linear_solvers/multigrid/cycle_matrix.h>
#include <stickslip/linear_solvers/multigrid/node_clusters.h>

#include <cstddef>
#include <vector>

namespace stickslip
{
  /**
   * The inverses of the blocks on the diagonal of a matrix: those of single
   * nodes, and, in single precision, of clusters of several nodes, which a
   * cycle reads much of.
   */
  class BlockDiagonal
  {
  public:
    /// Zero pivots (unknowns without stiffness) give zero.
    void
    reinit(const BlockMatrix &A, const NodeClusters &clusters);

    /// Unknowns of a cluster.
    unsigned int
    size(const unsigned int cluster) const
    {
      return sizes[cluster];
    }

    /// The largest size.
    unsigned int
    largest_size() const
    {
      return largest;
    }

    /// x = D^-1 b in the unknowns of a cluster, node after node; @p b may be
    /// longer.
    void
    solve(const unsigned int         cluster,
          const std::vector<double> &b,
          double                    *x) const;

  private:
    std::vector<unsigned int> sizes;
    unsigned int              largest = 0;
    std::vector<std::size_t>  begins;
    std::vector<double>       single_nodes; ///< by rows
    std::vector<bool>         is_single;
    CycleMatrix               of_clusters;
  };
} // namespace stickslip

#endif
