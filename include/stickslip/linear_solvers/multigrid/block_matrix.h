#ifndef stickslip_linear_solvers_multigrid_block_matrix_h
#define stickslip_linear_solvers_multigrid_block_matrix_h

#include <stickslip/linear_solvers/multigrid/block_rows.h>

#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * A distributed matrix of dense blocks, one row of blocks for each owned
   * node, in double precision: what coarser matrices are made of. Vectors of
   * columns have the layout of column_space(), those of rows hold the owned
   * unknowns first (and may be longer).
   */
  class BlockMatrix
  {
  public:
    BlockMatrix() = default;

    /**
     * Takes the values of @p rows, whose nodes have the unknowns
     * @p row_space says. @p column_space is that of the columns; its ghosts are
     * set here. Collective.
     */
    BlockMatrix(BlockRows<double> &&rows,
                const NodeSpace    &row_space,
                const NodeSpace    &column_space);

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

    const double *
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

    /// y += A x. Ghosts of @p x are up to date.
    void
    vmult_add(std::vector<double> &y, const std::vector<double> &x) const;

  private:
    NodeSpace                 space; ///< of the columns
    std::vector<unsigned int> row_begins{0};
    std::vector<unsigned int> widths;
    BlockRows<double>         rows; ///< with local numbers of columns
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



  /// Makes the columns of @p rows local numbers of the space that is returned:
  /// @p columns with the ghosts they need. Collective.
  template <typename Number>
  NodeSpace
  with_local_columns(BlockRows<Number> &rows, const NodeSpace &columns)
  {
    NodeSpace space(columns);
    space.set_ghosts(foreign_columns(rows, space));
    for (auto &column : rows.columns)
      column = space.local(column);
    return space;
  }



  /// First unknowns of the rows, and their end.
  template <typename Number>
  std::vector<unsigned int>
  begins_of_rows(const BlockRows<Number> &rows, const NodeSpace &space)
  {
    std::vector<unsigned int> begins;
    for (unsigned int row = 0; row <= rows.n_rows(); ++row)
      begins.push_back(space.begin(row));
    return begins;
  }
} // namespace stickslip

#endif
