#ifndef stickslip_linear_solvers_multigrid_block_rows_h
#define stickslip_linear_solvers_multigrid_block_rows_h

#include <stickslip/linear_solvers/multigrid/node_space.h>

#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * Rows of dense blocks of any size in compressed storage, by global column
   * nodes in ascending order. A row is a panel, the blocks side by side: all
   * entries of its first unknown, then those of the second one.
   */
  template <typename Number>
  struct BlockRows
  {
    using Index = NodeSpace::Index;

    std::vector<std::size_t>   column_begins{0};
    std::vector<std::size_t>   value_begins{0};
    std::vector<Index>         columns; ///< nodes
    std::vector<unsigned char> widths;  ///< unknowns of these nodes
    std::vector<Number>        values;

    unsigned int
    n_rows() const
    {
      return column_begins.size() - 1;
    }

    Number *
    panel(const unsigned int row)
    {
      return values.data() + value_begins[row];
    }

    const Number *
    panel(const unsigned int row) const
    {
      return values.data() + value_begins[row];
    }

    /// Entries of a row of the panel.
    unsigned int
    width(const unsigned int row) const
    {
      unsigned int sum = 0;
      for (auto k = column_begins[row]; k < column_begins[row + 1]; ++k)
        sum += widths[k];
      return sum;
    }

    /// Ends a row whose columns and widths have been appended; its nodes have
    /// @p height unknowns.
    void
    end_row(const unsigned int height)
    {
      column_begins.push_back(columns.size());
      value_begins.push_back(value_begins.back() +
                             std::size_t(height) * width(n_rows() - 1));
    }

    /// Makes the panels of rows that have ended; new ones are zero.
    void
    allocate()
    {
      values.resize(value_begins.back(), Number(0));
    }

    /// Appends row @p row of @p other.
    void
    append(const BlockRows &other, const unsigned int row)
    {
      columns.insert(columns.end(),
                     other.columns.begin() + other.column_begins[row],
                     other.columns.begin() + other.column_begins[row + 1]);
      widths.insert(widths.end(),
                    other.widths.begin() + other.column_begins[row],
                    other.widths.begin() + other.column_begins[row + 1]);
      values.insert(values.end(),
                    other.values.begin() + other.value_begins[row],
                    other.values.begin() + other.value_begins[row + 1]);
      column_begins.push_back(columns.size());
      value_begins.push_back(values.size());
    }

    /// For messages.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &column_begins &value_begins &columns &widths &values;
    }
  };



  /// sum += part for blocks, the rows of which begin so far apart.
  inline void
  add_block(const double      *part,
            const unsigned int part_stride,
            const unsigned int height,
            const unsigned int width,
            double            *sum,
            const unsigned int sum_stride)
  {
    for (unsigned int r = 0; r < height; ++r)
      for (unsigned int c = 0; c < width; ++c)
        sum[r * sum_stride + c] += part[r * part_stride + c];
  }



  /// The rows of the ghosts of @p space, which are with the other ranks'
  /// @p owned ones. Collective.
  template <typename Number>
  BlockRows<Number>
  ghost_rows(const BlockRows<Number> &owned, const NodeSpace &space);



  /// The sum over all ranks of their contributions to the owned rows: @p local
  /// has a row for each local node of @p space. Collective.
  BlockRows<double>
  sum_to_owners(BlockRows<double> &&local, const NodeSpace &space);
} // namespace stickslip

#endif
