#ifndef stickslip_solid_cylindrical_frame_h
#define stickslip_solid_cylindrical_frame_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * Directions of cylindrical components at a reference position X: radial,
   * away from the axis; circumferential, to the left of it when one looks
   * against the axis; and, in 3D, along the axis.
   */
  template <int dim>
  class CylindricalFrame
  {
  public:
    /// An axis through @p centre; @p axis has unit length. In 2D it is z.
    CylindricalFrame(const Point<dim> &centre, const Tensor<1, 3> &axis)
      : centre(centre)
      , axis(axis)
    {}

    /// Zero for the radial and the circumferential one on the axis itself.
    Tensor<1, dim>
    direction(const Point<dim> &position, const unsigned int component) const
    {
      Tensor<1, 3> radial;
      for (unsigned int d = 0; d < dim; ++d)
        radial[d] = position[d] - centre[d];
      const double size = radial.norm();
      radial -= (radial * axis) * axis;
      const double radius = radial.norm();
      radial = radius > 1e-12 * size ? radial / radius : Tensor<1, 3>();
      const Tensor<1, 3> full =
        component == 0
          ? radial
          : (component == 1 ? cross_product_3d(axis, radial) : axis);
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = full[d];
      return result;
    }

    /// The vector with these components.
    Tensor<1, dim>
    vector(const Point<dim> &position, const Tensor<1, dim> &components) const
    {
      Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result += components[c] * direction(position, c);
      return result;
    }

  private:
    Point<dim>   centre;
    Tensor<1, 3> axis;
  };
} // namespace stickslip

#endif
