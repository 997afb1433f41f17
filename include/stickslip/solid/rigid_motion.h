#ifndef stickslip_solid_rigid_motion_h
#define stickslip_solid_rigid_motion_h

#include <stickslip/base/space_time_function.h>
#include <stickslip/solid/boundary_condition_parameters.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * A translation c(t) and a rotation by an angle (given in degrees) about an
   * axis through a fixed centre x_0 of the reference configuration:
   * u(X, t) = c(t) + (Q(t) - I) (X - x_0). In 2D the axis is z.
   * Where the expressions of c and of the angle use x, y, z, these are the
   * centre's coordinates.
   */
  template <int dim>
  class RigidMotion
  {
  public:
    /// No motion.
    RigidMotion() = default;

    /// The law is multiplied by @p amplitude unless that is null. Throws
    /// UserError naming the parameter below @p path.
    RigidMotion(const BoundaryConditionParameters      &parameters,
                const std::shared_ptr<const Amplitude> &amplitude,
                const std::string                      &path);

    Tensor<1, dim>
    displacement(const Point<dim> &reference_position, const double time) const;

  private:
    // Evaluated at the centre only, so that the motion is rigid.
    std::shared_ptr<const SpaceTimeFunction<dim>> translation;
    std::shared_ptr<const SpaceTimeFunction<dim>> angle;
    Tensor<1, 3>                                  axis;
    Point<dim>                                    centre;
  };
} // namespace stickslip

#endif
