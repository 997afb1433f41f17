#ifndef stickslip_solid_load_h
#define stickslip_solid_load_h

#include <stickslip/base/types.h>

#include <stickslip/base/space_time_function.h>
#include <stickslip/solid/boundary_condition_parameters.h>

#include <memory>
#include <set>
#include <string>

namespace stickslip
{
  /**
   * One condition of the types traction, pressure, follower pressure, spring
   * and body force.
   */
  template <int dim>
  struct Load
  {
    std::string                  name;
    BoundaryConditionType        type;
    unsigned int                 body;
    std::set<types::boundary_id> boundary_ids; ///< global; body force: empty

    /// Traction, pressure or force per volume; not used by springs.
    std::shared_ptr<const SpaceTimeFunction<dim>> value;

    /// Spring: d d^T for a direction d, or the identity, times the stiffness
    /// (force per reference area and displacement).
    Tensor<2, dim> stiffness;
  };
} // namespace stickslip

#endif
