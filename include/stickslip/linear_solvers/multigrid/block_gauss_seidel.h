#ifndef stickslip_linear_solvers_multigrid_block_gauss_seidel_h
#define stickslip_linear_solvers_multigrid_block_gauss_seidel_h

#include <stickslip/linear_solvers/multigrid/block_matrix.h>
#include <stickslip/linear_solvers/multigrid/ordered_exchange.h>

#include <vector>

namespace stickslip
{
  /**
   * Gauss-Seidel sweeps that solve for all unknowns of a node at once, over all
   * ranks: first the nodes beside those of other ranks, rank after rank (see
   * OrderedExchange), then the others, all ranks at the same time. (Sweeps of
   * each rank for itself took up to a fifth more iterations on 4 ranks than on
   * one.)
   */
  class BlockGaussSeidel
  {
  public:
    /// Inverts the diagonal blocks of @p A; zero pivots (unknowns without
    /// stiffness) give zero. Sorts the columns of @p A by the order of the
    /// sweeps.
    void
    reinit(BlockMatrix<double> &A);

    /// Sets the matrix of the sweeps: that of reinit() in single precision,
    /// which has half its size, and reading it is what a sweep takes. Keeps a
    /// reference.
    void
    use(const BlockMatrix<float> &A)
    {
      matrix = &A;
    }

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

    /// y = D^-1 y in the @p n unknowns of a node.
    void
    scale(const unsigned int node, const unsigned int n, double *y) const;

    /**
     * The largest eigenvalue of D^-1 A, from below, by some steps of the power
     * method, for the @p A of reinit(). Collective.
     */
    double
    largest_eigenvalue(const BlockMatrix<double> &A) const;

    /// The inverse of a diagonal block, by rows.
    const double *
    inverse(const unsigned int node) const
    {
      return inverses.data() + inverse_begins[node];
    }

  private:
    const BlockMatrix<float> *matrix = nullptr;
    OrderedExchange           exchange;
    std::vector<unsigned int> order;      ///< of the owned nodes
    unsigned int             n_first = 0; ///< nodes beside those of other ranks
    std::vector<std::size_t> inverse_begins;
    std::vector<double>      inverses;
    std::vector<std::size_t> diagonals;     ///< positions in the columns
    std::vector<unsigned int> lower_widths; ///< before them in the panels

    mutable std::vector<double> lower_residual; ///< b - L x1
    mutable std::vector<double> defect;         ///< of one node

    /// The nodes beside those of other ranks come first.
    void
    set_order(const BlockMatrix<double> &A);

    /// Lower and upper parts of the rows, and the inverses.
    void
    split_rows(const BlockMatrix<double> &A);

    /// (D + L) x1 = b - U x, which leaves lower_residual.
    void
    sweep_forwards(std::vector<double>       &x,
                   const std::vector<double> &b,
                   const bool                 from_zero) const;

    /// (D + U) x = lower_residual; later ranks have their turn first.
    void
    sweep_backwards(std::vector<double> &x) const;

    /// x = D^-1 defect in one node.
    void
    set_from_defect(const unsigned int node, std::vector<double> &x) const;

    /// y -= L x and y -= U x in one node.
    void
    subtract_lower(const unsigned int         node,
                   const std::vector<double> &x,
                   double                    *y) const;

    void
    subtract_upper(const unsigned int         node,
                   const std::vector<double> &x,
                   double                    *y) const;
  };
} // namespace stickslip

#endif
