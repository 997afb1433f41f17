#ifndef stickslip_problem_body_support_h
#define stickslip_problem_body_support_h

#include <stickslip/contact/pairing/contact_pair.h>

#include <stickslip/mesh/body.h>

#include <stickslip/problem/dof_layout.h>

#include <stickslip/solid/boundary_conditions.h>
#include <stickslip/solid/rigid_body_check.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Throws UserError for bodies that nothing can hold: no boundary condition,
   * spring or contact pair one body, or no boundary condition or spring all of
   * the bodies that contact joins. Tells the contact pairs that have to hold a
   * body that they do. Collective.
   */
  template <int dim>
  void
  check_bodies_are_held(
    const BoundaryConditions<dim>                        &conditions,
    const Bodies                                         &bodies,
    const DofLayout<dim>                                 &dofs,
    const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs);

  /// Rigid motions that only springs softer than @p softest_spring (force per
  /// area and length) prevent. Collective.
  template <int dim>
  std::vector<FreeMotion>
  weakly_held_motions(const BoundaryConditions<dim> &conditions,
                      const Bodies                  &bodies,
                      const DofLayout<dim>          &dofs,
                      const double                   softest_spring);
} // namespace stickslip

#endif
