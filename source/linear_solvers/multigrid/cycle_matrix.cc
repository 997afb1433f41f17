#include <stickslip/linear_solvers/multigrid/cycle_matrix.h>

#include <stickslip/base/vectorized.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  namespace
  {
    using Lanes = FourLanes::Lanes;

    /// Values behind the last one that a product reads but does not use.
    constexpr unsigned int padding = 3;

    /// Blocks of a row, beginning with the entries @p values.
    struct Blocks
    {
      const float         *values;
      const unsigned int  *first_unknowns;
      const unsigned char *widths;
      std::size_t          n;
      unsigned int         height;
    };



    /// sums[k] += a_c x_c for the columns c = k, k + n_sums, ... of @p n; the
    /// sums do not wait for each other.
    template <unsigned int n_quads, unsigned int n_sums>
    [[gnu::always_inline]] inline void
    add_columns(const float       *a,
                const unsigned int height,
                const double      *x,
                const unsigned int n,
                Lanes (&sums)[n_sums][n_quads])
    {
      for (unsigned int c = 0; c < n; ++c, a += height)
        for (unsigned int q = 0; q < n_quads; ++q)
          sums[c % n_sums][q] += FourLanes::load(a + 4 * q) * x[c];
    }



    /// y += factor * A x in the rows [first_row, first_row + 4 n_quads) of
    /// @p blocks.
    template <unsigned int n_quads>
    [[gnu::always_inline]] inline void
    add_rows(const double       factor,
             const Blocks      &blocks,
             const unsigned int first_row,
             const double      *x,
             double            *y)
    {
      Lanes              sums[3][n_quads] = {};
      const float       *a                = blocks.values + first_row;
      const unsigned int height           = blocks.height;
      for (std::size_t k = 0; k < blocks.n; ++k)
        {
          const double *const values = x + blocks.first_unknowns[k];
          const unsigned int  width  = blocks.widths[k];
          // loops of a length that the compiler knows
          if (width == 3)
            add_columns(a, height, values, 3, sums);
          else if (width == 6)
            add_columns(a, height, values, 6, sums);
          else
            add_columns(a, height, values, width, sums);
          a += width * height;
        }
      for (unsigned int q = 0; q < n_quads; ++q)
        {
          const Lanes        sum = sums[0][q] + sums[1][q] + sums[2][q];
          const unsigned int row = first_row + 4 * q;
          for (unsigned int r = 0; r < std::min(4u, height - row); ++r)
            y[row + r] += factor * sum[r];
        }
    }



    /// y += factor * A x in all rows of @p blocks.
    STICKSLIP_VECTORIZED void
    add_products(const double  factor,
                 const Blocks &blocks,
                 const double *x,
                 double       *y)
    {
      unsigned int row = 0;
      for (; row + 4 < blocks.height; row += 8)
        add_rows<2>(factor, blocks, row, x, y);
      if (row < blocks.height)
        add_rows<1>(factor, blocks, row, x, y);
    }
  } // namespace



  CycleMatrix::CycleMatrix(const BlockMatrix               &matrix,
                           const Part                      &part,
                           const std::vector<unsigned int> &order)
    : rows(matrix.n_rows())
  {
    std::size_t n_values = padding, n_blocks = 0;
    for (unsigned int row = 0; row < rows.size(); ++row)
      {
        n_blocks += part.end[row] - part.begin[row];
        for (auto k = part.begin[row]; k < part.end[row]; ++k)
          n_values += matrix.block_width(k) * matrix.height(row);
      }
    values.resize(n_values);
    first_unknowns.reserve(n_blocks);
    widths.reserve(n_blocks);
    float *value = values.data();
    for (const unsigned int row : order)
      {
        const unsigned int height = matrix.height(row);
        const auto         begin = part.begin[row], end = part.end[row];
        rows[row] = {static_cast<std::size_t>(value - values.data()),
                     widths.size(),
                     static_cast<unsigned int>(end - begin),
                     height};
        const unsigned int  stride = matrix.width(row);
        const double *const panel  = matrix.panel(row);
        unsigned int        column = 0;
        for (auto k = matrix.column_begin(row); k < begin; ++k)
          column += matrix.block_width(k);
        for (auto k = begin; k < end; ++k)
          {
            first_unknowns.push_back(
              matrix.column_space().begin(matrix.column(k)));
            widths.push_back(matrix.block_width(k));
            for (const auto last = column + widths.back(); column < last;
                 ++column)
              for (unsigned int r = 0; r < height; ++r)
                *value++ = panel[r * stride + column];
          }
      }
  }



  CycleMatrix::CycleMatrix(BlockRows<float> &&block_rows,
                           const NodeSpace   &columns)
    : widths(std::move(block_rows.widths))
  {
    values.reserve(block_rows.values.size() + padding);
    std::size_t first_block = 0;
    for (unsigned int row = 0; row < block_rows.n_rows(); ++row)
      {
        const std::size_t end = block_rows.column_begins[row + 1];
        const std::size_t n_values =
          block_rows.value_begins[row + 1] - block_rows.value_begins[row];
        unsigned int width = 0;
        for (auto k = first_block; k < end; ++k)
          width += widths[k];
        const unsigned int height = width == 0 ? 0 : n_values / width;
        rows.push_back({values.size(),
                        first_block,
                        static_cast<unsigned int>(end - first_block),
                        height});
        for (unsigned int c = 0; c < width; ++c)
          for (unsigned int r = 0; r < height; ++r)
            values.push_back(block_rows.panel(row)[r * width + c]);
        first_block = end;
      }
    values.resize(values.size() + padding, 0.F);
    first_unknowns.reserve(block_rows.columns.size());
    for (const auto column : block_rows.columns)
      first_unknowns.push_back(columns.begin(column));
    block_rows = {};
  }



  void
  CycleMatrix::add_product(const unsigned int         row,
                           const double               factor,
                           const std::vector<double> &x,
                           double                    *y) const
  {
    const Row &place = rows[row];
    add_products(factor,
                 {values.data() + place.first_value,
                  first_unknowns.data() + place.first_block,
                  widths.data() + place.first_block,
                  place.n_blocks,
                  place.height},
                 x.data(),
                 y);
  }



  void
  CycleMatrix::add_transposed_product(const unsigned int   row,
                                      const double        *x,
                                      std::vector<double> &y) const
  {
    const Row   &place = rows[row];
    const float *entry = values.data() + place.first_value;
    for (auto k = place.first_block; k < place.first_block + place.n_blocks;
         ++k)
      for (unsigned int c = 0; c < widths[k]; ++c)
        {
          double sum = 0.;
          for (unsigned int r = 0; r < place.height; ++r)
            sum += *entry++ * x[r];
          y[first_unknowns[k] + c] += sum;
        }
  }

} // namespace stickslip
