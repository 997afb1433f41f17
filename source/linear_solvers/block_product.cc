#include <stickslip/linear_solvers/block_product.h>

#include <algorithm>

namespace stickslip
{
  OwnedEntries
  owned_entries(const LA::BlockVector &vector)
  {
    OwnedEntries entries;
    for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      entries.insert(entries.end(),
                     vector.block(b).begin(),
                     vector.block(b).end());
    return entries;
  }



  void
  set_owned_entries(LA::BlockVector &vector, const OwnedEntries &entries)
  {
    auto next = entries.begin();
    for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      {
        const auto end = next + vector.block(b).locally_owned_size();
        std::copy(next, end, vector.block(b).begin());
        next = end;
      }
  }



  void
  BlockProduct::reinit(const LA::BlockSparseMatrix &matrix)
  {
    for (unsigned int row = 0; row < 2; ++row)
      {
        n_rows[row] =
          matrix.block(row, row).locally_owned_range_indices().n_elements();
        for (unsigned int column = 0; column < 2; ++column)
          blocks[row][column].reinit(matrix.block(row, column));
      }
  }



  template <typename Finish>
  void
  BlockProduct::for_each_block(const OwnedEntries &x,
                               const unsigned int  n_columns,
                               const Finish       &finish) const
  {
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < n_columns; ++column)
        blocks[row][column].start(x.data() + column * n_rows[0]);
    for (unsigned int row = 0; row < 2; ++row)
      for (unsigned int column = 0; column < n_columns; ++column)
        finish(row, column, x.data() + column * n_rows[0]);
  }



  void
  BlockProduct::set_part(const OwnedEntries &marks)
  {
    for_each_block(marks,
                   2,
                   [&](const unsigned int  row,
                       const unsigned int  column,
                       const double *const from) {
                     rows_of_part[row][column] =
                       blocks[row][column].rows_that_see(from);
                   });
  }



  void
  BlockProduct::add_part(OwnedEntries &y, const OwnedEntries &x) const
  {
    for_each_block(x,
                   2,
                   [&](const unsigned int  row,
                       const unsigned int  column,
                       const double *const from) {
                     blocks[row][column].finish_add(y.data() + row * n_rows[0],
                                                    from,
                                                    rows_of_part[row][column]);
                   });
  }



  void
  BlockProduct::vmult(OwnedEntries       &y,
                      const OwnedEntries &x,
                      const unsigned int  n_columns) const
  {
    y.assign(n_rows[0] + n_rows[1], 0.);
    for_each_block(x,
                   n_columns,
                   [&](const unsigned int  row,
                       const unsigned int  column,
                       const double *const from) {
                     blocks[row][column].finish_add(y.data() + row * n_rows[0],
                                                    from);
                   });
  }



  void
  BlockProduct::vmult(OwnedEntries &y, const OwnedEntries &x) const
  {
    vmult(y, x, 2);
  }



  void
  BlockProduct::vmult_displacements(OwnedEntries       &y,
                                    const OwnedEntries &x) const
  {
    vmult(y, x, 1);
  }
} // namespace stickslip
