#ifndef stickslip_contact_point_handed_over_points_h
#define stickslip_contact_point_handed_over_points_h

#include <stickslip/contact/point/contact_point.h>
#include <stickslip/contact/surface/hanging_nodes.h>

#include <deal.II/dofs/dof_handler.h>

#include <vector>

namespace stickslip
{
  /**
   * Removes the contact points at @p hanging nodes, of rules with one point per
   * multiplier: the law holds where there is a multiplier of its own. The
   * points at the nodes that these hang on take over their weights, each with
   * the node's share: a constant pressure gives the same forces as before.
   *
   * @p keys has the multiplier nodes of the faces of this rank, [face * n + l].
   * Does nothing on meshes without hanging nodes. Collective.
   */
  template <int dim>
  void
  hand_over_points(const HangingNodes                         &hanging,
                   const DoFHandler<dim>                      &dof_handler,
                   const std::vector<types::global_dof_index> &keys,
                   const unsigned int              n_multipliers_of_face,
                   std::vector<ContactPoint<dim>> &points);
} // namespace stickslip

#endif
