#ifndef stickslip_contact_pairing_far_surfaces_h
#define stickslip_contact_pairing_far_surfaces_h

#include <stickslip/contact/pairing/mortar_integrals.h>

#include <vector>

namespace stickslip
{
  /**
   * Whether the average of @p node says that it is closed, or hardly open,
   * while the surfaces are far apart wherever they are opposite: dual functions
   * change sign, and a gap that rises steeply, as beside a round master, is no
   * polynomial.
   *
   * Far is more than half of the shortest distance between the nodes of a
   * (undeformed) face at all integration points on it, and at the node itself
   * where a master is opposite. They may be less: where a round surface
   * touches, and where the end of a master does between two nodes.
   *
   * A node is open when its average falls so much that it loses its partner:
   * hardly open is a quarter of that distance.
   */
  template <int dim>
  bool
  is_closed_from_afar(const FaceShape<dim>                  &shape,
                      const MortarNode<dim>                 &node,
                      const std::vector<MortarFace<dim>>    &faces,
                      const std::vector<FaceSegments<dim>>  &segments,
                      const std::vector<FaceIntegrals<dim>> &integrals,
                      const MasterPatch<dim>                &patch);
} // namespace stickslip

#endif
