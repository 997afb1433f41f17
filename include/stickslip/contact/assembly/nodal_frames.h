#ifndef stickslip_contact_assembly_nodal_frames_h
#define stickslip_contact_assembly_nodal_frames_h

#include <stickslip/contact/assembly/contact_assembler.h>

namespace stickslip
{
  /**
   * Renews ContactPoint::nodal_rotations from the present frames of the paired
   * points (3D; there is nothing to turn in 2D). The first axis of a node is
   * the weighted mean of the directions that its points give it by way of their
   * reference_rotations; each point then sees this one axis, projected on its
   * tangent plane. So the points of a node agree on what its Lambda is although
   * the faces that carry their frames deform differently. Rigid rotations leave
   * the nodal rotations as they are. Collective.
   */
  template <int dim>
  void
  update_nodal_frames(ContactAssembler<dim> &contact);
} // namespace stickslip

#endif
