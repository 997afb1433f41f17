#ifndef stickslip_contact_point_handed_over_points_h
#define stickslip_contact_point_handed_over_points_h

#include <stickslip/contact/point/contact_parameters.h>
#include <stickslip/contact/point/contact_point.h>
#include <stickslip/contact/surface/hanging_nodes.h>

#include <deal.II/dofs/dof_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What becomes of the contact points where slave nodes are @p hanging; does
   * nothing where none is.
   *
   * Of rules with one point per multiplier those at hanging nodes are removed:
   * the law holds where there is a multiplier of its own. The points at the
   * nodes that these hang on take over their weights, each with the node's
   * share: a constant pressure gives the same forces as before. Other rules
   * keep their points; they interpolate multipliers of hanging nodes, which
   * needs one frame for all of them: with friction in 3D they are refused
   * (UserError that blames the pair @p path, on all ranks).
   *
   * @p keys has the multiplier nodes of the faces of this rank, [face * n + l].
   * Collective.
   */
  template <int dim>
  void
  hand_over_points(const HangingNodes                         &hanging,
                   const DoFHandler<dim>                      &dof_handler,
                   const std::vector<types::global_dof_index> &keys,
                   const unsigned int              n_multipliers_of_face,
                   const ContactPairParameters    &parameters,
                   const std::string              &path,
                   std::vector<ContactPoint<dim>> &points);
} // namespace stickslip

#endif
