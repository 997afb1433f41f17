#include <stickslip/linear_solvers/multigrid/product_row.h>

#include <stickslip/base/vectorized.h>

namespace stickslip
{
  namespace
  {
    template <typename Number>
    [[gnu::always_inline]] inline void
    multiply_rows(const double      *a,
                  const unsigned int a_stride,
                  const unsigned int n_rows,
                  const unsigned int n_inner,
                  const Number      *b,
                  const unsigned int b_stride,
                  const unsigned int n_columns,
                  double            *product)
    {
      using namespace FourLanes;
      const unsigned int n_full = n_columns - n_columns % 4;
      for (unsigned int i = 0; i < n_rows; ++i, a += a_stride)
        {
          for (unsigned int c = 0; c < n_full; c += 4)
            {
              Lanes lanes = zero();
              for (unsigned int k = 0; k < n_inner; ++k)
                lanes += a[k] * load(b + k * b_stride + c);
              store(product + c, lanes);
            }
          for (unsigned int c = n_full; c < n_columns; ++c)
            {
              product[c] = 0.;
              for (unsigned int k = 0; k < n_inner; ++k)
                product[c] += a[k] * b[k * b_stride + c];
            }
          product += n_columns;
        }
    }
  } // namespace



  STICKSLIP_VECTORIZED void
  multiply_panel(const double      *a,
                 const unsigned int a_stride,
                 const unsigned int n_rows,
                 const unsigned int n_inner,
                 const float       *b,
                 const unsigned int b_stride,
                 const unsigned int n_columns,
                 double            *product)
  {
    multiply_rows(
      a, a_stride, n_rows, n_inner, b, b_stride, n_columns, product);
  }



  STICKSLIP_VECTORIZED void
  multiply_panel(const double      *a,
                 const unsigned int a_stride,
                 const unsigned int n_rows,
                 const unsigned int n_inner,
                 const double      *b,
                 const unsigned int b_stride,
                 const unsigned int n_columns,
                 double            *product)
  {
    multiply_rows(
      a, a_stride, n_rows, n_inner, b, b_stride, n_columns, product);
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
        const unsigned int j = A.column(k), part_width = P.width(j);
        part.resize(height * part_width);
        multiply_panel(block,
                       A.width(row),
                       height,
                       A.block_width(k),
                       P.panel(j),
                       part_width,
                       part_width,
                       part.data());
        block += A.block_width(k);
        unsigned int offset = 0;
        for (auto l = P.column_begins[j]; l < P.column_begins[j + 1]; ++l)
          {
            add_block(part.data() + offset,
                      part_width,
                      height,
                      P.widths[l],
                      values.data() + pattern.offset(columns[l]),
                      width);
            offset += P.widths[l];
          }
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
