#ifndef stickslip_contact_point_law_corners_h
#define stickslip_contact_point_law_corners_h

#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /// How far the corners of the contact law are rounded for a while
  /// (cycling/law_continuation.h). The equations of a case have none rounded.
  struct LawRounding
  {
    double pressure = 0.; ///< width of the corner of S_c [stress]
    double disc     = 0.; ///< width of the edge of the unit disc

    bool
    acts() const
    {
      return pressure > 0.;
    }
  };



  /// min(g, 0) and its derivative.
  struct NegativePart
  {
    double value = 0.;
    double slope = 0.;
  };

  /**
   * min(g, 0), on the branch that @p is_negative says; with a @p width > 0 the
   * smooth function (g - sqrt(g^2 + width^2))/2 of Chen and Harker (SIAM J.
   * Matrix Anal. 14, 1993), whatever @p is_negative. With g = lambda - r d,
   * lambda = min(g, 0) then means lambda d = width^2/(4 r) with both negative:
   * the path that interior point methods follow.
   */
  NegativePart
  negative_part(const double g, const bool is_negative, const double width);



  /// Projection T on the disc of radius one and its derivative.
  template <int dim>
  struct DiscProjection
  {
    Tensor<1, dim> T;
    Tensor<2, dim> derivative;
  };

  /**
   * g inside of the disc, g/|g| outside of it, as @p is_inside says; zero where
   * g = 0 is to be projected from outside. With a @p width > 0 the smooth
   * function of the same direction and the length
   * (sqrt((|g| + 1)^2 + width^2) - sqrt((|g| - 1)^2 + width^2))/2 < 1.
   */
  template <int dim>
  DiscProjection<dim>
  disc_projection(const Tensor<1, dim> &g,
                  const bool            is_inside,
                  const double          width);
} // namespace stickslip

#endif
