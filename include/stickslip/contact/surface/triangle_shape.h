#ifndef stickslip_contact_surface_triangle_shape_h
#define stickslip_contact_surface_triangle_shape_h

#include <stickslip/contact/surface/face_shape.h>

#include <deal.II/base/point.h>

#include <vector>

/// Lagrange shape functions of degree 1 and 2 on the triangle xi_1, xi_2 >= 0,
/// xi_1 + xi_2 <= 1. deal.II's FE_SimplexP has the same in the same order, but
/// a contact point asks for them often.
namespace stickslip
{
  /// The vertices and, for degree 2, the middles of the edges 01, 12, 20.
  std::vector<Point<2>>
  triangle_nodes(const unsigned int degree);

  void
  evaluate_triangle_values(const unsigned int   degree,
                           const Point<2>      &xi,
                           std::vector<double> &value);

  void
  evaluate_triangle_gradients(const unsigned int  degree,
                              const Point<2>     &xi,
                              FaceShapeValues<3> &shape);

  void
  evaluate_triangle(const unsigned int  degree,
                    const Point<2>     &xi,
                    FaceShapeValues<3> &shape);
} // namespace stickslip

#endif
