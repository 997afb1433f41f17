#ifndef stickslip_solid_pretension_h
#define stickslip_solid_pretension_h

#include <stickslip/base/amplitude.h>
#include <stickslip/base/space_time_function.h>

#include <stickslip/mesh/body.h>

#include <stickslip/solid/active_interval.h>
#include <stickslip/solid/boundary_condition_parameters.h>

#include <array>
#include <memory>
#include <set>
#include <string>

namespace stickslip
{
  /**
   * One condition of the type pretension: a plane cut through a bolt, whose
   * sides a force draws over each other until that is locked.
   */
  template <int dim>
  struct Pretension
  {
    /// One side of the cut.
    struct Side
    {
      unsigned int                 body;
      std::set<types::boundary_id> boundary_ids; ///< global
    };

    /// Throws UserError for unknown bodies and boundaries, rigid bodies and
    /// wrong expressions.
    Pretension(const std::string                      &name,
               const BoundaryConditionParameters      &parameters,
               const Bodies                           &bodies,
               const std::shared_ptr<const Amplitude> &amplitude);

    /// True as long as the force acts, the time of locking included.
    bool
    is_drawn(const double time) const
    {
      return drawn.contains(time);
    }

    /// The tension in the whole bolt; in 2D per unit of thickness, or, of
    /// bodies of revolution, all around.
    double
    force(const double time) const
    {
      return force_law->value(Point<dim>(), time);
    }

    std::string         name; ///< as in the parameter file
    std::array<Side, 2> sides;

  private:
    std::shared_ptr<SpaceTimeFunction<dim>> force_law;
    ActiveInterval                          drawn;
  };
} // namespace stickslip

#endif
