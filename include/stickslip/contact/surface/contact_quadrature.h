#ifndef stickslip_contact_surface_contact_quadrature_h
#define stickslip_contact_surface_contact_quadrature_h

#include <stickslip/base/choice.h>
#include <stickslip/contact/surface/face_shape.h>

#include <deal.II/base/quadrature.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /// The rules that place the contact points on a slave face.
  enum class ContactRule
  {
    nodal,
    Gauss,
    Simpson,
    Newton_Cotes,
    segments ///< averages over intersections of slave and master faces
  };

  const Choices<ContactRule> &
  all_contact_rules();

  /**
   * True if the contact law holds at each node of the multipliers, so that each
   * multiplier belongs to one law: the discrete equations are then the
   * contact law at each point, and their solution does not depend on the
   * regularization parameters.
   */
  inline bool
  has_one_multiplier_per_point(const ContactRule rule)
  {
    return rule == ContactRule::nodal || rule == ContactRule::segments;
  }

  /**
   * The points and weights of @p rule on a slave face (paper, 2.2).
   *
   * - `nodal`: at the nodes of the multiplier space (trapezoid for degree 1,
   * Simpson for 2, Gauss-Lobatto above);
   * - `Gauss` with @p order points per direction (1 to 20);
   * - `Simpson` with @p order subintervals (1 to 20);
   * - `Newton-Cotes` with @p order intervals, order + 1 points (1 to 7 and 9:
   *   order 8 has negative weights, which the contact law cannot take);
   * - `segments`: the points of `nodal`, at which averages are then taken
   *   (pairing/mortar_surface.h).
   *
   * Tensor products on [0,1]^(facedim); on triangles `nodal` (the vertices),
   * `Gauss` (1 to 4, with the exactness of that order) and `segments`. Throws
   * UserError naming @p path.
   */
  template <int dim>
  Quadrature<dim - 1>
  contact_quadrature(const ContactRule     rule,
                     const unsigned int    order,
                     const FaceShape<dim> &multiplier_shape,
                     const std::string    &path);

  /**
   * Throws UserError if a slave face has fewer points than multipliers: then
   * some combination of these vanishes at all points, in any mesh but the
   * coarsest. @p path as above.
   */
  template <int dim>
  void
  check_multipliers_are_determined(const Quadrature<dim - 1> &quadrature,
                                   const FaceShape<dim>      &multiplier_shape,
                                   const std::string         &path);
} // namespace stickslip

#endif
