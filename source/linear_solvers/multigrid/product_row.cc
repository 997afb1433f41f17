#include <stickslip/linear_solvers/multigrid/product_row.h>

#include <stickslip/base/vectorized.h>

#include <cstring>

namespace stickslip
{
  namespace
  {
    struct Quad
    {
      using Lanes = FourLanes::Lanes;

      template <typename Number>
      [[gnu::always_inline]] static Lanes
      load(const Number *const x)
      {
        return FourLanes::load(x);
      }
    };



    struct Pair
    {
      using Lanes = double __attribute__((vector_size(16)));

      template <typename Number>
      [[gnu::always_inline]] static Lanes
      load(const Number *const x)
      {
        return Lanes{x[0], x[1]};
      }
    };



    /// As many columns of a product as @p Block has lanes, with @p n_inner
    /// columns of a. The rows of b are read once for all rows of a.
    template <typename Block,
              unsigned int n_inner,
              typename Coefficient,
              typename Number>
    [[gnu::always_inline]] inline void
    add_columns(const Coefficient *a,
                const unsigned int a_row,
                const unsigned int a_column,
                const unsigned int n_rows,
                const Number      *b,
                const unsigned int b_stride,
                double            *sum,
                const unsigned int sum_stride)
    {
      typename Block::Lanes b_rows[n_inner];
      for (unsigned int k = 0; k < n_inner; ++k)
        b_rows[k] = Block::load(b + k * b_stride);
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          double *const         target = sum + i * sum_stride;
          typename Block::Lanes lanes  = Block::load(target);
          for (unsigned int k = 0; k < n_inner; ++k)
            lanes += double(a[i * a_row + k * a_column]) * b_rows[k];
          std::memcpy(target, &lanes, sizeof(lanes));
        }
    }



    template <unsigned int n_inner, typename Coefficient, typename Number>
    [[gnu::always_inline]] inline void
    add_inner(const Coefficient *a,
              const unsigned int a_row,
              const unsigned int a_column,
              const unsigned int n_rows,
              const Number      *b,
              const unsigned int b_stride,
              const unsigned int n_columns,
              double            *sum,
              const unsigned int sum_stride)
    {
      unsigned int c = 0;
      for (; c + 4 <= n_columns; c += 4)
        add_columns<Quad, n_inner>(
          a, a_row, a_column, n_rows, b + c, b_stride, sum + c, sum_stride);
      for (; c + 2 <= n_columns; c += 2)
        add_columns<Pair, n_inner>(
          a, a_row, a_column, n_rows, b + c, b_stride, sum + c, sum_stride);
      for (; c < n_columns; ++c)
        for (unsigned int i = 0; i < n_rows; ++i)
          for (unsigned int k = 0; k < n_inner; ++k)
            sum[i * sum_stride + c] +=
              double(a[i * a_row + k * a_column]) * b[k * b_stride + c];
    }



    template <typename Coefficient, typename Number>
    [[gnu::always_inline]] inline void
    add_panel(const Coefficient *a,
              const unsigned int a_row,
              const unsigned int a_column,
              const unsigned int n_rows,
              const unsigned int n_inner,
              const Number      *b,
              const unsigned int b_stride,
              const unsigned int n_columns,
              double            *sum,
              const unsigned int sum_stride)
    {
      unsigned int k = 0;
      // three components of a node, six modes of an aggregate
      for (; k + 3 <= n_inner; k += 3)
        add_inner<3>(a + k * a_column,
                     a_row,
                     a_column,
                     n_rows,
                     b + k * b_stride,
                     b_stride,
                     n_columns,
                     sum,
                     sum_stride);
      for (; k < n_inner; ++k)
        add_inner<1>(a + k * a_column,
                     a_row,
                     a_column,
                     n_rows,
                     b + k * b_stride,
                     b_stride,
                     n_columns,
                     sum,
                     sum_stride);
    }
  } // namespace



  STICKSLIP_VECTORIZED void
  add_panel_product(const double      *a,
                    const unsigned int a_row,
                    const unsigned int a_column,
                    const unsigned int n_rows,
                    const unsigned int n_inner,
                    const float       *b,
                    const unsigned int b_stride,
                    const unsigned int n_columns,
                    double            *sum,
                    const unsigned int sum_stride)
  {
    add_panel(a,
              a_row,
              a_column,
              n_rows,
              n_inner,
              b,
              b_stride,
              n_columns,
              sum,
              sum_stride);
  }



  STICKSLIP_VECTORIZED void
  add_panel_product(const double      *a,
                    const unsigned int a_row,
                    const unsigned int a_column,
                    const unsigned int n_rows,
                    const unsigned int n_inner,
                    const double      *b,
                    const unsigned int b_stride,
                    const unsigned int n_columns,
                    double            *sum,
                    const unsigned int sum_stride)
  {
    add_panel(a,
              a_row,
              a_column,
              n_rows,
              n_inner,
              b,
              b_stride,
              n_columns,
              sum,
              sum_stride);
  }



  STICKSLIP_VECTORIZED void
  add_panel_product(const float       *a,
                    const unsigned int a_row,
                    const unsigned int a_column,
                    const unsigned int n_rows,
                    const unsigned int n_inner,
                    const double      *b,
                    const unsigned int b_stride,
                    const unsigned int n_columns,
                    double            *sum,
                    const unsigned int sum_stride)
  {
    add_panel(a,
              a_row,
              a_column,
              n_rows,
              n_inner,
              b,
              b_stride,
              n_columns,
              sum,
              sum_stride);
  }


  template <typename Number>
  void
  ProductRow::compute(const BlockMatrix               &A,
                      const BlockRows<Number>         &P,
                      const std::vector<unsigned int> &columns,
                      const unsigned int               row)
  {
    pattern.clear();
    for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
      for (auto l = P.column_begins[A.column(k)];
           l < P.column_begins[A.column(k) + 1];
           ++l)
        pattern.insert(columns[l]);
    width                     = pattern.arrange();
    const unsigned int height = A.height(row);
    values.assign(height * width, 0.);
    const double *block = A.panel(row);
    for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
      {
        const unsigned int j      = A.column(k);
        const Number      *b      = P.panel(j);
        const unsigned int stride = P.width(j);
        const auto         end    = P.column_begins[j + 1];
        for (auto l = P.column_begins[j]; l < end;)
          {
            // blocks that are side by side in the product, too
            const unsigned int offset = pattern.offset(columns[l]);
            unsigned int       n      = 0;
            do
              n += P.widths[l++];
            while (l < end && pattern.offset(columns[l]) == offset + n);
            add_panel_product(block,
                              A.width(row),
                              1,
                              height,
                              A.block_width(k),
                              b,
                              stride,
                              n,
                              values.data() + offset,
                              width);
            b += n;
          }
        block += A.block_width(k);
      }
  }



  template void
  ProductRow::compute(const BlockMatrix &,
                      const BlockRows<float> &,
                      const std::vector<unsigned int> &,
                      const unsigned int);
  template void
  ProductRow::compute(const BlockMatrix &,
                      const BlockRows<double> &,
                      const std::vector<unsigned int> &,
                      const unsigned int);
} // namespace stickslip
