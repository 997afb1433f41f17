#ifndef stickslip_solid_rigid_motion_h
#define stickslip_solid_rigid_motion_h

#include <stickslip/base/space_time_function.h>
#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/rigid_state.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * The motion of a rigid body or of a boundary that is rigid, given by its
   * components: the dim translations c of a reference point x_0, and those of
   * the rotation vector (1 in 2D, 3 in 3D), in degrees, along the Rotation axis
   * and two axes across it, or along x, y, z if all three are given. Each is a
   * law of the time or free. u(X, t) = c + (R - I) (X - x_0). Along free
   * components a force at the reference point and a torque drive the body, and
   * springs hold it. Where the expressions use x, y, z, these are the
   * coordinates of x_0.
   */
  template <int dim>
  class RigidMotion
  {
  public:
    static constexpr unsigned int n_rotations  = (dim == 2 ? 1 : 3);
    static constexpr unsigned int n_components = dim + n_rotations;

    /// No motion.
    RigidMotion() = default;

    /// All laws but stiffnesses are multiplied by @p amplitude unless that is
    /// null. Throws UserError naming the parameter below @p path.
    RigidMotion(const BoundaryConditionParameters      &parameters,
                const std::shared_ptr<const Amplitude> &amplitude,
                const std::string                      &path);

    /// Free components taken as zero.
    Tensor<1, dim>
    displacement(const Point<dim> &reference_position, const double time) const;

    bool
    is_free(const unsigned int component) const
    {
      return free_components[component];
    }

    bool
    has_free_components() const;

    bool
    has_free_rotation() const;

    const Point<dim> &
    reference_point() const
    {
      return centre;
    }

    /// Gives the components that are not free the values of their laws.
    void
    prescribe(const double time, RigidState<dim> &state) const;

    /// Axis of a rotation component.
    const Tensor<1, 3> &
    rotation_axis(const unsigned int component) const
    {
      return axes[component - dim];
    }

    /// What a unit of a rotation component adds to the rotation: the spin w of
    /// d R = [w x] R. If all rotations are free, they are spins themselves.
    Tensor<1, 3>
    spin(const unsigned int component, const RigidState<dim> &state) const;

    /// @p state moved along a free component by a small @p step, as spin() says.
    RigidState<dim>
    moved(const unsigned int     component,
          const double           step,
          const RigidState<dim> &state) const;

    /// Force or torque that drives a free component. Not of its spring.
    double
    driving_force(const unsigned int     component,
                  const double           time,
                  const RigidState<dim> &state) const;

    /// What the springs exert along a free component.
    double
    spring_force(const unsigned int     component,
                 const RigidState<dim> &state) const;

    /// Of the spring along a component (a torque per radian); zero if there is
    /// none.
    double
    stiffness(const unsigned int component) const
    {
      return stiffnesses[component];
    }

    /// Throws UserError if a force or torque is given for a component that is
    /// not free.
    void
    check_forces(const double time) const;

  private:
    /// Null: zero. Evaluated at the centre only, so that the motion is rigid.
    using Law = std::shared_ptr<const SpaceTimeFunction<dim>>;

    std::string                           path;
    Law                                   translation, angle, force, torque;
    std::array<bool, n_components>        free_components{};
    std::array<double, n_components>      stiffnesses{};
    std::array<Tensor<1, 3>, n_rotations> axes;
    Point<dim>                            centre;
    bool                                  has_rotation_vector = false;

    void
    check(const BoundaryConditionParameters &parameters) const;

    void
    read_stiffnesses(const BoundaryConditionParameters &parameters);

    bool
    all_rotations_are_free() const;

    /// Law of a rotation component in radians; zero if it is free or has none.
    double
    rotation_value(const unsigned int component, const double time) const;

    /// Force or torque along a component; zero if there is none.
    double
    load(const unsigned int component, const double time) const;
  };
} // namespace stickslip

#endif
