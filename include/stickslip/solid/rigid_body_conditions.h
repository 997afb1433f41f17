#ifndef stickslip_solid_rigid_body_conditions_h
#define stickslip_solid_rigid_body_conditions_h

#include <stickslip/mesh/body.h>

#include <stickslip/solid/prescribed_displacement.h>

#include <vector>

namespace stickslip
{
  /// Whether one of @p conditions on @p body has free components.
  template <int dim>
  bool
  has_coupling(const std::vector<PrescribedDisplacement<dim>> &conditions,
               const unsigned int                              body);

  /// Throws UserError for a rigid body that a force moves and that has another
  /// condition.
  template <int dim>
  void
  check_couplings_of_rigid_bodies(
    const std::vector<PrescribedDisplacement<dim>> &conditions,
    const Bodies                                   &bodies);

  /// One motion without a displacement for each rigid body that no condition
  /// moves.
  template <int dim>
  std::vector<PrescribedDisplacement<dim>>
  holds_of_idle_rigid_bodies(
    const std::vector<PrescribedDisplacement<dim>> &conditions,
    const Bodies                                   &bodies);
} // namespace stickslip

#endif
