#ifndef stickslip_contact_surface_contact_quadrature_h
#define stickslip_contact_surface_contact_quadrature_h

#include <deal.II/base/quadrature.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * The rule that places the contact points on a slave face (paper, 2.2).
   *
   * - `nodal`: at the nodes of the multiplier space of degree
   *   @p multiplier_degree (trapezoid for 1, Simpson for 2, Gauss-Lobatto above);
   * - `Gauss` with @p order points per direction (1 to 20);
   * - `Simpson` with @p order subintervals (1 to 20);
   * - `Newton-Cotes` with @p order intervals, order + 1 points (1 to 7 and 9:
   *   order 8 has negative weights, which the contact law cannot take).
   *
   * Tensor products on [0,1]^(facedim). Throws UserError naming @p path.
   */
  template <int facedim>
  Quadrature<facedim>
  contact_quadrature(const std::string &name,
                     const unsigned int order,
                     const unsigned int multiplier_degree,
                     const std::string &path);

  /**
   * Throws UserError if a slave face has fewer points than multipliers: then
   * some combination of these vanishes at all points, in any mesh but the
   * coarsest. @p path as above.
   */
  template <int facedim>
  void
  check_multipliers_are_determined(const Quadrature<facedim> &quadrature,
                                   const unsigned int         multiplier_degree,
                                   const std::string         &path);
} // namespace stickslip

#endif
