#ifndef stickslip_solid_load_h
#define stickslip_solid_load_h

#include <stickslip/base/types.h>

#include <stickslip/base/space_time_function.h>
#include <stickslip/solid/active_interval.h>
#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/cylindrical_frame.h>
#include <stickslip/solid/force_distribution.h>

#include <memory>
#include <optional>
#include <set>
#include <string>

namespace stickslip
{
  /**
   * One condition of the types traction, pressure, follower pressure, spring,
   * body force and distributed force.
   */
  template <int dim>
  struct Load
  {
    std::string                  name;
    BoundaryConditionType        type;
    unsigned int                 body;
    std::set<types::boundary_id> boundary_ids; ///< global; body force: empty

    /// Traction, pressure or force per volume; not used by springs
    /// and distributed forces.
    std::shared_ptr<const SpaceTimeFunction<dim>> value;

    /// Spring: d d^T for a direction d, or the identity, times the stiffness
    /// (force per reference area and displacement).
    Tensor<2, dim> stiffness;

    /// Of a distributed force. BoundaryConditions measures its
    /// boundary.
    std::shared_ptr<ForceDistribution<dim>> distribution;

    ActiveInterval active;

    /// Of the components of a traction or a body force, if not Cartesian.
    std::optional<CylindricalFrame<dim>> frame;

    /// Force per reference area or volume at a reference position X.
    Tensor<1, dim>
    vector(const Point<dim> &X, const double time) const
    {
      if (!active.contains(time))
        return {};
      const Tensor<1, dim> components = value->vector(X, time);
      return frame ? frame->vector(X, components) : components;
    }

    /// True if it is applied to boundary faces.
    bool
    is_on_surface() const
    {
      return type != BoundaryConditionType::body_force;
    }

    double
    pressure(const Point<dim> &X, const double time) const
    {
      return active.contains(time) ? value->value(X, time) : 0.;
    }
  };
} // namespace stickslip

#endif
