#include <stickslip/contact/point/law_corners.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Up to here |g| is too small to divide by; the projection is linear
    /// there.
    constexpr double negligible_length = 1e-12;
  } // namespace



  NegativePart
  negative_part(const double g, const bool is_negative, const double width)
  {
    if (width == 0.)
      return is_negative ? NegativePart{g, 1.} : NegativePart{0., 0.};
    const double root = std::hypot(g, width);
    // two forms, so that nothing cancels
    const double value =
      g > 0. ? -0.5 * width * width / (g + root) : 0.5 * (g - root);
    return {value, -value / root};
  }



  template <int dim>
  DiscProjection<dim>
  disc_projection(const Tensor<1, dim> &g,
                  const bool            is_inside,
                  const double          width)
  {
    const Tensor<2, dim> I      = unit_symmetric_tensor<dim>();
    const double         length = g.norm();
    if (width == 0. && is_inside)
      return {g, I};
    if (width == 0.)
      {
        // by coincidence without a direction: no friction, no division by 0
        if (length == 0.)
          return {g, Tensor<2, dim>()};
        return {g / length,
                (I - outer_product(g, g) / (length * length)) / length};
      }
    const double far   = std::hypot(length + 1., width);
    const double near  = std::hypot(length - 1., width);
    const double slope = 0.5 * ((length + 1.) / far - (length - 1.) / near);
    if (length < negligible_length)
      return {slope * g, slope * I};
    const Tensor<1, dim> e = g / length;
    // the difference of the two roots, without cancellation
    const double         projected = 2. * length / (far + near);
    const Tensor<2, dim> along     = outer_product(e, e);
    return {projected * e, slope * along + projected / length * (I - along)};
  }

  template DiscProjection<2>
  disc_projection(const Tensor<1, 2> &, const bool, const double);
  template DiscProjection<3>
  disc_projection(const Tensor<1, 3> &, const bool, const double);
} // namespace stickslip
