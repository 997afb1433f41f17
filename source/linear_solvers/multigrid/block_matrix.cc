#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Four sums side by side, so that the processor need not wait for one.
    template <typename Number>
    double
    product(const Number *a, const double *x, const unsigned int n)
    {
      double       s0 = 0., s1 = 0., s2 = 0., s3 = 0.;
      unsigned int k = 0;
      for (; k + 4 <= n; k += 4)
        {
          s0 += a[k] * x[k];
          s1 += a[k + 1] * x[k + 1];
          s2 += a[k + 2] * x[k + 2];
          s3 += a[k + 3] * x[k + 3];
        }
      for (; k < n; ++k)
        s0 += a[k] * x[k];
      return (s0 + s1) + (s2 + s3);
    }
  } // namespace



  template <typename Number>
  BlockMatrix<Number>::BlockMatrix(BlockRows<Number> &&block_rows,
                                   const NodeSpace    &row_space,
                                   const NodeSpace    &column_space)
    : space(column_space)
    , rows(std::move(block_rows))
  {
    space.set_ghosts(foreign_columns(rows, space));
    for (auto &column : rows.columns)
      column = space.local(column);
    unsigned int largest = 0;
    for (unsigned int row = 0; row < rows.n_rows(); ++row)
      {
        row_begins.push_back(row_space.begin(row + 1));
        widths.push_back(rows.width(row));
        largest = std::max(largest, widths.back());
      }
    gathered.resize(largest);
  }



  template <typename Number>
  void
  BlockMatrix<Number>::sort_columns(const std::vector<unsigned int> &place)
  {
    struct Block
    {
      unsigned int  column;
      unsigned char width;
      unsigned int  offset; ///< in the panel
    };
    std::vector<Block>  blocks;
    std::vector<Number> before;
    const auto          comes_first = [&](const Block &a, const Block &b) {
      return place[a.column] < place[b.column];
    };
    for (unsigned int row = 0; row < n_rows(); ++row)
      {
        const std::size_t begin = rows.column_begins[row];
        unsigned int      width = 0;
        blocks.clear();
        for (std::size_t k = begin; k < rows.column_begins[row + 1]; ++k)
          {
            blocks.push_back({rows.columns[k], rows.widths[k], width});
            width += rows.widths[k];
          }
        if (std::is_sorted(blocks.begin(), blocks.end(), comes_first))
          continue;
        std::stable_sort(blocks.begin(), blocks.end(), comes_first);
        Number *target = rows.panel(row);
        before.assign(target, target + height(row) * width);
        for (unsigned int r = 0; r < height(row); ++r)
          for (const Block &block : blocks)
            target = std::copy_n(before.begin() + r * width + block.offset,
                                 block.width,
                                 target);
        for (unsigned int k = 0; k < blocks.size(); ++k)
          {
            rows.columns[begin + k] = blocks[k].column;
            rows.widths[begin + k]  = blocks[k].width;
          }
      }
  }



  template <typename Number>
  void
  BlockMatrix<Number>::subtract_product(const unsigned int         row,
                                        const std::size_t          first,
                                        const std::size_t          end,
                                        const unsigned int         offset,
                                        const std::vector<double> &x,
                                        double                    *y) const
  {
    unsigned int n = 0;
    for (std::size_t k = first; k < end; ++k)
      {
        const double *const values = x.data() + space.begin(rows.columns[k]);
        for (unsigned int c = 0; c < rows.widths[k]; ++c)
          gathered[n++] = values[c];
      }
    const Number *entries = panel(row) + offset;
    for (unsigned int r = 0; r < height(row); ++r, entries += widths[row])
      y[r] -= product(entries, gathered.data(), n);
  }



  template <typename Number>
  void
  BlockMatrix<Number>::residual(std::vector<double>       &y,
                                const std::vector<double> &x,
                                const std::vector<double> &b) const
  {
    std::copy_n(b.begin(), row_begins.back(), y.begin());
    for (unsigned int row = 0; row < n_rows(); ++row)
      subtract_product(row,
                       rows.column_begins[row],
                       rows.column_begins[row + 1],
                       0,
                       x,
                       y.data() + row_begins[row]);
  }



  template <typename Number>
  void
  BlockMatrix<Number>::vmult_add(std::vector<double>       &y,
                                 const std::vector<double> &x) const
  {
    for (unsigned int row = 0; row < n_rows(); ++row)
      {
        unsigned int n = 0;
        for (std::size_t k = rows.column_begins[row];
             k < rows.column_begins[row + 1];
             ++k)
          for (unsigned int c = 0; c < rows.widths[k]; ++c)
            gathered[n++] = x[space.begin(rows.columns[k]) + c];
        const Number *entries = panel(row);
        for (unsigned int r = 0; r < height(row); ++r, entries += n)
          y[row_begins[row] + r] += product(entries, gathered.data(), n);
      }
  }



  template <typename Number>
  void
  BlockMatrix<Number>::Tvmult(std::vector<double>       &y,
                              const std::vector<double> &x) const
  {
    y.assign(space.begin(space.n_local()), 0.);
    for (unsigned int row = 0; row < n_rows(); ++row)
      {
        const Number *entries = panel(row);
        for (std::size_t k = rows.column_begins[row];
             k < rows.column_begins[row + 1];
             ++k)
          {
            double *const values = y.data() + space.begin(rows.columns[k]);
            for (unsigned int r = 0; r < height(row); ++r)
              {
                const double value = x[row_begins[row] + r];
                for (unsigned int c = 0; c < rows.widths[k]; ++c)
                  values[c] += entries[r * widths[row] + c] * value;
              }
            entries += rows.widths[k];
          }
      }
    space.add_ghosts_to_owners(y);
  }



  template <typename Number>
  std::size_t
  BlockMatrix<Number>::memory_consumption() const
  {
    return rows.values.size() * sizeof(Number) +
           rows.columns.size() * (sizeof(NodeSpace::Index) + 1) +
           rows.column_begins.size() * 2 * sizeof(std::size_t);
  }

  template class BlockMatrix<float>;
  template class BlockMatrix<double>;
} // namespace stickslip
