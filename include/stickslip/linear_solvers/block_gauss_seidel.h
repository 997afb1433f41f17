#ifndef stickslip_linear_solvers_block_gauss_seidel_h
#define stickslip_linear_solvers_block_gauss_seidel_h

#include <stickslip/linear_solvers/block_matrix.h>

namespace stickslip
{
  /**
   * Gauss-Seidel sweeps that solve for all unknowns of a node at once. Between
   * ranks they are Jacobi sweeps.
   */
  class BlockGaussSeidel
  {
  public:
    /// Inverts the diagonal blocks; zero pivots (unknowns without stiffness)
    /// give zero. Keeps a reference to @p matrix.
    void
    reinit(const BlockMatrix<double> &matrix);

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

    /// y = D^-1 y in the unknowns of a node.
    void
    scale(const unsigned int node, double *y) const;

    /**
     * The largest eigenvalue of D^-1 A, from below, by some steps of the power
     * method. Collective.
     */
    double
    largest_eigenvalue() const;

    /// The inverse of a diagonal block, by rows.
    const double *
    inverse(const unsigned int node) const
    {
      return inverses.data() + inverse_begins[node];
    }

  private:
    const BlockMatrix<double> *matrix = nullptr;
    std::vector<std::size_t>   inverse_begins;
    std::vector<double>        inverses;
    std::vector<std::size_t>   diagonals;    ///< positions in the columns
    std::vector<unsigned int>  lower_widths; ///< before them in the panels

    mutable std::vector<double> lower_residual; ///< b - L x1
    mutable std::vector<double> defect;         ///< of one node

    /// (D + U) x = lower_residual, from the last node to the first one.
    void
    sweep_backwards(std::vector<double> &x) const;

    /// x = D^-1 defect in one node.
    void
    set_from_defect(const unsigned int node, std::vector<double> &x) const;

    /// y -= L x and y -= U x in one node; L and U have the ghosts before and
    /// behind the owned nodes.
    void
    subtract_lower(const unsigned int         node,
                   const std::vector<double> &x,
                   double                    *y) const;

    void
    subtract_upper(const unsigned int         node,
                   const std::vector<double> &x,
                   double                    *y) const;

    /// The same with the ghosts behind the owned nodes.
    void
    subtract_ghosts_behind(const unsigned int         node,
                           const std::vector<double> &x,
                           double                    *y) const;
  };
} // namespace stickslip

#endif
