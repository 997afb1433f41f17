#ifndef stickslip_linear_solvers_multigrid_read_blocks_h
#define stickslip_linear_solvers_multigrid_read_blocks_h

#include <stickslip/base/types.h>

#include <stickslip/linear_solvers/multigrid/block_rows.h>

namespace stickslip
{
  /**
   * A matrix in blocks of @p height times @p width entries, without blocks that
   * are zero.
   */
  template <typename Number>
  BlockRows<Number>
  read_blocks(const LA::SparseMatrix &matrix,
              const unsigned int      height,
              const unsigned int      width);



  /**
   * A square matrix plus @p added (which may have no rows at all) in blocks of
   * @p n unknowns, without blocks that are zero, except those on the diagonal.
   */
  BlockRows<double>
  read_square_blocks(const LA::SparseMatrix  &matrix,
                     const unsigned int       n,
                     const BlockRows<double> &added = {});
} // namespace stickslip

#endif
