#ifndef stickslip_solid_tangent_products_h
#define stickslip_solid_tangent_products_h

namespace stickslip
{
  /**
   * K_(a i)(k b) += G_aJ A_iJkL G_bL, what a quadrature point adds to the
   * stiffness of a cell with @p n nodes: gradients G_aJ at [J * n + a], moduli
   * A with the weight of the point, K at [((a * 2 + i) * 2 + k) * n + b].
   */
  void
  add_tangent_products(const unsigned int n,
                       const double      *G,
                       const double (&A)[2][2][2][2],
                       double *K);

  /// In space: K at [((a * 3 + i) * 3 + k) * n + b].
  void
  add_tangent_products(const unsigned int n,
                       const double      *G,
                       const double (&A)[3][3][3][3],
                       double *K);
} // namespace stickslip

#endif
