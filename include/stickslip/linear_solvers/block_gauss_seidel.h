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

    /// One sweep forwards and one backwards from x = 0. Collective.
    void
    solve(std::vector<double> &x, const std::vector<double> &b) const;

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
    std::vector<unsigned int>  n_before; ///< columns before the diagonal block

    mutable std::vector<double> defect; ///< of one node

    /// x += D^-1 (b - A x) for one node.
    void
    relax(const unsigned int         node,
          const unsigned int         n_columns,
          std::vector<double>       &x,
          const std::vector<double> &b) const;

    void
    sweep_backwards(std::vector<double> &x, const std::vector<double> &b) const;
  };
} // namespace stickslip

#endif
