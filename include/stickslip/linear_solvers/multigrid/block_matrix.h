#ifndef stickslip_linear_solvers_multigrid_block_matrix_h
#define stickslip_linear_solvers_multigrid_block_matrix_h

#include <stickslip/linear_solvers/multigrid/block_rows.h>

#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * A distributed matrix of dense blocks, one row of blocks for each owned
   * node, ready for products. Vectors of columns have the layout of
   * column_space(), those of rows hold the owned unknowns first (and may be
   * longer).
   */
  template <typename Number>
  class BlockMatrix
  {
  public:
    BlockMatrix() = default;

    /**
     * Takes the values of @p rows, whose nodes have the unknowns
     * @p row_space says. @p column_space is that of the columns; its ghosts are
     * set here. Collective.
     */
    BlockMatrix(BlockRows<Number> &&rows,
                const NodeSpace    &row_space,
                const NodeSpace    &column_space);

    /// Takes the matrix @p other, whose numbers have another precision.
    template <typename OtherNumber>
    explicit BlockMatrix(BlockMatrix<OtherNumber> &&other)
      : space(std::move(other.space))
      , row_begins(std::move(other.row_begins))
      , widths(std::move(other.widths))
      , gathered(std::move(other.gathered))
    {
      rows.take(std::move(other.rows));
    }

    unsigned int
    n_rows() const
    {
      return row_begins.size() - 1;
    }

    const NodeSpace &
    column_space() const
    {
      return space;
    }

    /// Local numbers of the columns of a row: [column_begin(row),
    /// column_begin(row + 1)).
    std::size_t
    column_begin(const unsigned int row) const
    {
      return rows.column_begins[row];
    }

    unsigned int
    column(const std::size_t k) const
    {
      return rows.columns[k];
    }

    unsigned int
    block_width(const std::size_t k) const
    {
      return rows.widths[k];
    }

    const Number *
    panel(const unsigned int row) const
    {
      return rows.panel(row);
    }

    unsigned int
    width(const unsigned int row) const
    {
      return widths[row];
    }

    /// First unknown of a row.
    unsigned int
    row_begin(const unsigned int row) const
    {
      return row_begins[row];
    }

    unsigned int
    height(const unsigned int row) const
    {
      return row_begins[row + 1] - row_begins[row];
    }

    /// Sorts the blocks of each row by @p place of their column (a local node).
    void
    sort_columns(const std::vector<unsigned int> &place);

    /**
     * y -= A x in one row of blocks, where A has its columns [first, end) only;
     * @p offset is the width of those before. Ghosts of @p x are up to date;
     * @p y has the height of the row.
     */
    void
    subtract_product(const unsigned int         row,
                     const std::size_t          first,
                     const std::size_t          end,
                     const unsigned int         offset,
                     const std::vector<double> &x,
                     double                    *y) const;

    /// y = b - A x. Ghosts of @p x are up to date.
    void
    residual(std::vector<double>       &y,
             const std::vector<double> &x,
             const std::vector<double> &b) const;

    /// y += A x. Ghosts of @p x are up to date.
    void
    vmult_add(std::vector<double> &y, const std::vector<double> &x) const;

    /// y = A^T x, summed up over the ranks: y gets the layout of
    /// column_space(). Collective.
    void
    Tvmult(std::vector<double> &y, const std::vector<double> &x) const;

    /// Bytes of entries and their numbers on this rank.
    std::size_t
    memory_consumption() const;

  private:
    template <typename>
    friend class BlockMatrix;

    NodeSpace                 space; ///< of the columns
    std::vector<unsigned int> row_begins{0};
    std::vector<unsigned int> widths;
    BlockRows<Number>         rows; ///< with local numbers of columns

    mutable std::vector<double> gathered; ///< what a row sees of a vector

    /// Gathers what columns [first, end) see of @p x; returns how much.
    unsigned int
    gather(const std::size_t          first,
           const std::size_t          end,
           const std::vector<double> &x) const;
  };



  /// The nodes of other ranks in the columns of @p rows.
  template <typename Number>
  std::vector<NodeSpace::Index>
  foreign_columns(const BlockRows<Number> &rows, const NodeSpace &space)
  {
    std::vector<NodeSpace::Index> foreign;
    for (const auto column : rows.columns)
      if (!space.owns(column))
        foreign.push_back(column);
    return foreign;
  }
} // namespace stickslip

#endif
