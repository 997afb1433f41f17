#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <algorithm>
#include <utility>

namespace stickslip
{
  BlockMatrix::BlockMatrix(BlockRows<double> &&block_rows,
                           const NodeSpace    &row_space,
                           const NodeSpace    &column_space)
    : space(with_local_columns(block_rows, column_space))
    , row_begins(begins_of_rows(block_rows, row_space))
    , rows(std::move(block_rows))
  {
    for (unsigned int row = 0; row < rows.n_rows(); ++row)
      widths.push_back(rows.width(row));
  }



  void
  BlockMatrix::sort_columns(const std::vector<unsigned int> &place)
  {
    struct Block
    {
      unsigned int  column;
      unsigned char width;
      unsigned int  offset; ///< in the panel
    };
    std::vector<Block>  blocks;
    std::vector<double> before;
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
        double *target = rows.panel(row);
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



  void
  BlockMatrix::vmult_add(std::vector<double>       &y,
                         const std::vector<double> &x) const
  {
    for (unsigned int row = 0; row < n_rows(); ++row)
      {
        unsigned int offset = 0;
        for (auto k = column_begin(row); k < column_begin(row + 1); ++k)
          {
            const double *const values = x.data() + space.begin(column(k));
            for (unsigned int r = 0; r < height(row); ++r)
              for (unsigned int c = 0; c < block_width(k); ++c)
                y[row_begins[row] + r] +=
                  panel(row)[r * width(row) + offset + c] * values[c];
            offset += block_width(k);
          }
      }
  }
} // namespace stickslip
