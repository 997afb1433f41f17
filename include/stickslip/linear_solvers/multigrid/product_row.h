#ifndef stickslip_linear_solvers_multigrid_product_row_h
#define stickslip_linear_solvers_multigrid_product_row_h

#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <deal.II/base/array_view.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  /**
   * sum += a b for parts of panels. a(i, k) is a[i * a_row + k * a_column], so
   * that a may be transposed; rows of b and of the sum begin @p b_row and
   * @p sum_row apart.
   */
  struct PanelProduct
  {
    unsigned int n_rows, n_inner, n_columns;
    unsigned int a_row, a_column, b_row, sum_row;

    void
    add(const double *a, const float *b, double *sum) const;

    void
    add(const double *a, const double *b, double *sum) const;

    void
    add(const float *a, const double *b, double *sum) const;
  };



  /**
   * A row of blocks that is a sum of others: where each column node is in it.
   * The nodes are given by local numbers.
   */
  class RowPattern
  {
  public:
    explicit RowPattern(const NodeSpace &space)
      : space(space)
      , offsets(space.n_local(), numbers::invalid_unsigned_int)
    {}

    void
    clear()
    {
      for (const unsigned int node : nodes)
        offsets[node] = numbers::invalid_unsigned_int;
      nodes.clear();
    }

    void
    insert(const unsigned int node)
    {
      if (offsets[node] == numbers::invalid_unsigned_int)
        {
          offsets[node] = 0;
          nodes.push_back(node);
        }
    }

    /// Ends the insertions: sorts the nodes by their global numbers. Returns
    /// the width of the row.
    unsigned int
    arrange()
    {
      std::sort(nodes.begin(),
                nodes.end(),
                [&](const unsigned int a, const unsigned int b) {
                  return space.global(a) < space.global(b);
                });
      unsigned int width = 0;
      for (const unsigned int node : nodes)
        {
          offsets[node] = width;
          width += space.size(node);
        }
      return width;
    }

    unsigned int
    offset(const unsigned int node) const
    {
      return offsets[node];
    }

    std::vector<unsigned int> nodes;

  private:
    const NodeSpace          &space;
    std::vector<unsigned int> offsets;
  };



  /// A row of blocks of A P, or some of them with the columns of all.
  class ProductRow
  {
  public:
    /// @p space: local nodes of the columns of P.
    explicit ProductRow(const NodeSpace &space)
      : pattern(space)
    {}

    /// Rows of A P one below the other, where @p columns are the local numbers
    /// of the columns of @p P, which has the rows of all local columns of A.
    template <typename Number>
    void
    compute(const BlockMatrix                   &A,
            const BlockRows<Number>             &P,
            const std::vector<unsigned int>     &columns,
            const ArrayView<const unsigned int> &rows);

    RowPattern          pattern;
    unsigned int        width = 0;
    std::vector<double> values; ///< a panel
  };
} // namespace stickslip

#endif
