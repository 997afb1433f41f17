#ifndef stickslip_contact_pairing_corner_tangents_h
#define stickslip_contact_pairing_corner_tangents_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/contact_point.h>
#include <stickslip/contact/point/mortar_node.h>

#include <vector>

namespace stickslip
{
  /// The direction that carries the tangents of a node, at the present
  /// positions of @p faces.
  template <int dim>
  Tensor<1, dim>
  tangent_direction(const MortarNode<dim>              &node,
                    const std::vector<MortarFace<dim>> &faces)
  {
    if (node.fixed_direction)
      return *node.fixed_direction;
    const auto    &around = node.faces[node.direction_around];
    Tensor<1, dim> direction;
    for (unsigned int k = 0; k < around.stencil.size(); ++k)
      direction +=
        node.direction[around.stencil[k]] * faces[around.face].positions[k];
    return direction;
  }



  /// In space the tangents of a node on a symmetry plane begin with the normal
  /// of the plane, which is one of them whatever happens in the plane: what is
  /// held of the slip is always the same component. @p point is that of the
  /// node.
  template <int dim>
  void
  align_with_symmetry_plane(const FaceShape<dim>               &shape,
                            const std::vector<MortarFace<dim>> &faces,
                            MortarNode<dim>                    &node,
                            ContactPoint<dim>                  &point);

  /**
   * Chooses the directions that carry the tangent bases of corners, at the
   * present positions of @p faces. A basis needs a direction that is not along
   * the normal, and the normal may be any of the corner's cone: round an edge
   * it may be that of one face, along which another one has its direction. The
   * present direction stays where it is far enough from the cone; otherwise it
   * is the one that is farthest among some of each face (of an edge: along it).
   * @p points are those of the nodes; the frames of their nodal multipliers
   * stay.
   */
  template <int dim>
  void
  choose_tangent_directions(const FaceShape<dim>               &shape,
                            const std::vector<MortarFace<dim>> &faces,
                            std::vector<MortarNode<dim>>       &nodes,
                            std::vector<ContactPoint<dim>>     &points);
} // namespace stickslip

#endif
