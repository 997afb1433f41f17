#ifndef stickslip_contact_pairing_mortar_nodes_h
#define stickslip_contact_pairing_mortar_nodes_h

#include <stickslip/contact/pairing/mortar_face.h>
#include <stickslip/contact/point/contact_points.h>
#include <stickslip/contact/point/mortar_node.h>
#include <stickslip/contact/surface/hanging_nodes.h>

#include <set>
#include <vector>

namespace stickslip
{
  /**
   * Makes the mortar @p nodes of this rank, with their stencils, and the
   * @p faces around them; @p points are those of the nodal rule, of which one
   * per node is kept. See the constructor of MortarSurface. Not collective.
   */
  template <int dim>
  void
  collect_mortar_nodes(const FaceShape<dim> &displacement_shape,
                       const FaceShape<dim> &multiplier_shape,
                       const std::vector<CollectedFace<dim>>   &slaves,
                       const std::set<types::global_dof_index> &excluded,
                       const HangingNodes                      &hanging,
                       const std::vector<SlaveFace<dim>>       &owned_faces,
                       std::vector<ContactPoint<dim>>          &points,
                       std::vector<MortarFace<dim>>            &faces,
                       std::vector<MortarNode<dim>>            &nodes);
} // namespace stickslip

#endif
