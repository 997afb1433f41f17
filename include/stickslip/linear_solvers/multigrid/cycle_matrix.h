#ifndef stickslip_linear_solvers_multigrid_cycle_matrix_h
#define stickslip_linear_solvers_multigrid_cycle_matrix_h

#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <cstddef>
#include <vector>

namespace stickslip
{
  /**
   * Rows of dense blocks as a multigrid cycle reads them, and reading is what
   * it takes: in single precision, row after row in the order of the sweep, and
   * the entries of a row column after column, so that a product treats the
   * unknowns of a node at a time and sums up nothing across them. Vectors as
   * for BlockMatrix.
   */
  class CycleMatrix
  {
  public:
    /// Positions of blocks of a BlockMatrix: [begin, end) by row.
    struct Part
    {
      std::vector<std::size_t> begin, end;
    };

    CycleMatrix() = default;

    /// The blocks @p part of @p matrix. Its rows are stored in the given
    /// @p order.
    CycleMatrix(const BlockMatrix               &matrix,
                const Part                      &part,
                const std::vector<unsigned int> &order);

    /// Takes @p rows, whose columns are local numbers of @p columns.
    CycleMatrix(BlockRows<float> &&rows, const NodeSpace &columns);

    unsigned int
    n_rows() const
    {
      return rows.size();
    }

    /// y += factor * A x in one row of blocks. Ghosts of @p x are up to date;
    /// @p y has the height of the row.
    void
    add_product(const unsigned int         row,
                const double               factor,
                const std::vector<double> &x,
                double                    *y) const;

    /// y += A^T x for the unknowns @p x of one row of blocks; @p y has the
    /// layout of the columns, with contributions to ghosts.
    void
    add_transposed_product(const unsigned int   row,
                           const double        *x,
                           std::vector<double> &y) const;

  private:
    struct Row
    {
      std::size_t  first_value, first_block;
      unsigned int n_blocks, height;
    };

    std::vector<Row>           rows;
    std::vector<unsigned int>  first_unknowns; ///< of the columns, by block
    std::vector<unsigned char> widths;
    std::vector<float>         values;
  };
} // namespace stickslip

#endif
