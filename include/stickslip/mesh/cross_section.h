#ifndef stickslip_mesh_cross_section_h
#define stickslip_mesh_cross_section_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * What the points of a two-dimensional model stand for: of a slice of unit
   * thickness, or of bodies of revolution about y, where x is the radius.
   */
  struct CrossSection
  {
    bool is_axisymmetric = false;

    /// Radii up to this one [length] are zero but for roundoff.
    double radius_of_axis = 0.;

    /// By which lengths and areas of the model are multiplied for areas and
    /// volumes of the bodies: the way around the axis through the undeformed
    /// place @p X, 2 pi X_1 [length], or 1.
    template <int dim>
    double
    circumference(const Tensor<1, dim> &X) const
    {
      return is_axisymmetric ? 2. * numbers::PI * X[0] : 1.;
    }

    template <int dim>
    bool
    is_on_axis(const Tensor<1, dim> &X) const
    {
      return is_axisymmetric && X[0] <= radius_of_axis;
    }
  };
} // namespace stickslip

#endif
