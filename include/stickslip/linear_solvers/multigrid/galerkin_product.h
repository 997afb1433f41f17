#ifndef stickslip_linear_solvers_multigrid_galerkin_product_h
#define stickslip_linear_solvers_multigrid_galerkin_product_h

#include <stickslip/linear_solvers/multigrid/block_gauss_seidel.h>

namespace stickslip
{
  /**
   * P = (1 - omega D^-1 A) P0 with the blocks D on the diagonal of A and omega
   * = 4/3 over the largest eigenvalue of D^-1 A (Vanek, Mandel, Brezina 1996).
   * @p tentative has the rows of the owned nodes, @p coarse is the space of its
   * columns. Collective.
   */
  BlockRows<float>
  smoothed_prolongation(const BlockMatrix       &matrix,
                        const BlockGaussSeidel  &smoother,
                        const BlockRows<double> &tentative,
                        const NodeSpace         &coarse);



  /// P^T A P; @p coarse is the space of the columns of P. Without a product in
  /// between: row by row of A P, which goes into the result at once.
  /// Collective.
  template <typename Number>
  BlockRows<double>
  galerkin_product(const BlockMatrix       &matrix,
                   const BlockRows<Number> &prolongation,
                   const NodeSpace         &coarse);
} // namespace stickslip

#endif
