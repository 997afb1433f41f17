#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <stickslip/base/vectorized.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// y_r += factor * sum_k a_rk x_k for the rows r of @p a, which begin
    /// @p stride apart.
    template <typename Number>
    [[gnu::always_inline]] inline void
    add_products(const double       factor,
                 const Number      *a,
                 const unsigned int stride,
                 const unsigned int n_rows,
                 const double      *x,
                 const unsigned int n,
                 double            *y)
    {
      using namespace FourLanes;
      const unsigned int n_full = n - n % 4;
      for (unsigned int r = 0; r < n_rows; ++r, a += stride)
        {
          Lanes lanes = zero();
          for (unsigned int k = 0; k < n_full; k += 4)
            lanes += load(a + k) * load(x + k);
          double product = sum(lanes);
          for (unsigned int k = n_full; k < n; ++k)
            product += a[k] * x[k];
          y[r] += factor * product;
        }
    }



    /// The same for the matrices of the cycle.
    STICKSLIP_VECTORIZED void
    add_products(const double       factor,
                 const float       *a,
                 const unsigned int stride,
                 const unsigned int n_rows,
                 const double      *x,
                 const unsigned int n,
                 double            *y)
    {
      add_products<float>(factor, a, stride, n_rows, x, n, y);
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
  unsigned int
  BlockMatrix<Number>::gather(const std::size_t          first,
                              const std::size_t          end,
                              const std::vector<double> &x) const
  {
    double *next = gathered.data();
    for (std::size_t k = first; k < end; ++k)
      {
        const double *const values = x.data() + space.begin(rows.columns[k]);
        // without calling a function for three numbers
        for (unsigned int c = 0; c < rows.widths[k]; ++c)
          next[c] = values[c];
        next += rows.widths[k];
      }
    return next - gathered.data();
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
    const unsigned int n = gather(first, end, x);
    add_products(-1.,
                 panel(row) + offset,
                 widths[row],
                 height(row),
                 gathered.data(),
                 n,
                 y);
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
        const unsigned int n =
          gather(rows.column_begins[row], rows.column_begins[row + 1], x);
        add_products(1.,
                     panel(row),
                     n,
                     height(row),
                     gathered.data(),
                     n,
                     y.data() + row_begins[row]);
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
