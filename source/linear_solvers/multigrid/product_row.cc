#include <stickslip/linear_solvers/multigrid/product_row.h>

#include <stickslip/base/vectorized.h>

#include <cstring>

namespace stickslip
{
  namespace
  {
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
    add_columns(const PanelProduct &panel,
                const Coefficient  *a,
                const Number       *b,
                double             *sum)
    {
      typename Block::Lanes b_rows[n_inner];
      for (unsigned int k = 0; k < n_inner; ++k)
        b_rows[k] = Block::load(b + k * panel.b_row);
      for (unsigned int i = 0; i < panel.n_rows; ++i)
        {
          double *const         target = sum + i * panel.sum_row;
          typename Block::Lanes lanes  = Block::load(target);
          for (unsigned int k = 0; k < n_inner; ++k)
            lanes +=
              double(a[i * panel.a_row + k * panel.a_column]) * b_rows[k];
          std::memcpy(target, &lanes, sizeof(lanes));
        }
    }



    /// The part of a product with @p n_inner columns of a.
    template <unsigned int n_inner, typename Coefficient, typename Number>
    [[gnu::always_inline]] inline void
    add_inner(const PanelProduct &panel,
              const Coefficient  *a,
              const Number       *b,
              double             *sum)
    {
      unsigned int c = 0;
      for (; c + 4 <= panel.n_columns; c += 4)
        add_columns<FourLanes, n_inner>(panel, a, b + c, sum + c);
      for (; c + 2 <= panel.n_columns; c += 2)
        add_columns<Pair, n_inner>(panel, a, b + c, sum + c);
      for (; c < panel.n_columns; ++c)
        for (unsigned int i = 0; i < panel.n_rows; ++i)
          for (unsigned int k = 0; k < n_inner; ++k)
            sum[i * panel.sum_row + c] +=
              double(a[i * panel.a_row + k * panel.a_column]) *
              b[k * panel.b_row + c];
    }



    template <typename Coefficient, typename Number>
    [[gnu::always_inline]] inline void
    add_panel(const PanelProduct &panel,
              const Coefficient  *a,
              const Number       *b,
              double             *sum)
    {
      unsigned int k = 0;
      // three components of a node, six modes of an aggregate
      for (; k + 3 <= panel.n_inner; k += 3)
        add_inner<3>(panel, a + k * panel.a_column, b + k * panel.b_row, sum);
      for (; k < panel.n_inner; ++k)
        add_inner<1>(panel, a + k * panel.a_column, b + k * panel.b_row, sum);
    }
  } // namespace



  STICKSLIP_VECTORIZED void
  PanelProduct::add(const double *a, const float *b, double *sum) const
  {
    add_panel(*this, a, b, sum);
  }



  STICKSLIP_VECTORIZED void
  PanelProduct::add(const double *a, const double *b, double *sum) const
  {
    add_panel(*this, a, b, sum);
  }



  STICKSLIP_VECTORIZED void
  PanelProduct::add(const float *a, const double *b, double *sum) const
  {
    add_panel(*this, a, b, sum);
  }



  template <typename Number>
  void
  ProductRow::compute(const BlockMatrix                   &A,
                      const BlockRows<Number>             &P,
                      const std::vector<unsigned int>     &columns,
                      const ArrayView<const unsigned int> &rows)
  {
    pattern.clear();
    unsigned int total_height = 0;
    for (const unsigned int row : rows)
      {
        total_height += A.height(row);
        for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
          for (auto l = P.column_begins[A.column(k)];
               l < P.column_begins[A.column(k) + 1];
               ++l)
            pattern.insert(columns[l]);
      }
    width = pattern.arrange();
    values.assign(total_height * width, 0.);
    double *sum = values.data();
    for (const unsigned int row : rows)
      {
        const unsigned int height = A.height(row);
        const double      *block  = A.panel(row);
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
                const PanelProduct panel{
                  height, A.block_width(k), n, A.width(row), 1, stride, width};
                panel.add(block, b, sum + offset);
                b += n;
              }
            block += A.block_width(k);
          }
        sum += height * width;
      }
  }



  template void
  ProductRow::compute(const BlockMatrix &,
                      const BlockRows<float> &,
                      const std::vector<unsigned int> &,
                      const ArrayView<const unsigned int> &);
  template void
  ProductRow::compute(const BlockMatrix &,
                      const BlockRows<double> &,
                      const std::vector<unsigned int> &,
                      const ArrayView<const unsigned int> &);
} // namespace stickslip
