#ifndef stickslip_problem_rigid_part_h
#define stickslip_problem_rigid_part_h

#include <stickslip/mesh/body.h>

#include <stickslip/problem/dof_layout.h>

#include <stickslip/solid/rigid_body_check.h>

#include <vector>

namespace stickslip
{
  /// For each body the angle [radian] of the rotation in the rigid motion that
  /// is nearest to the displacement @p u at the vertices of its cells. @p u has
  /// ghosts. Collective.
  template <int dim>
  std::vector<double>
  mean_rotations(const Bodies         &bodies,
                 const DofLayout<dim> &dofs,
                 const LA::Vector     &u);

  /// Takes out of @p u, a displacement of owned entries, what it has of
  /// @p motions; those of the same bodies follow on each other. Collective.
  template <int dim>
  void
  remove_motions(const std::vector<FreeMotion> &motions,
                 const Bodies                  &bodies,
                 const DofLayout<dim>          &dofs,
                 LA::Vector                    &u);
} // namespace stickslip

#endif
