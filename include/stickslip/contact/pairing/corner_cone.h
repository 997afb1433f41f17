#ifndef stickslip_contact_pairing_corner_cone_h
#define stickslip_contact_pairing_corner_cone_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <vector>

namespace stickslip
{
  /**
   * Finds the nodes at which the slave surface has an edge: the undeformed
   * normals of two of their faces differ by more than `sharpest_smooth_kink`.
   * Sets MortarNode::is_corner. Ends of the surface are no corners.
   */
  template <int dim>
  void
  find_corners(const FaceShape<dim>               &shape,
               const std::vector<MortarFace<dim>> &faces,
               std::vector<MortarNode<dim>>       &nodes);

  /// The unit normal of a face around a node, at the node.
  template <int dim>
  struct ConeGenerator
  {
    Tensor<1, dim> direction;
    unsigned int   around = 0; ///< number of the face
  };

  /// What spans the cone of normals of a corner in the present configuration:
  /// the normals of the faces around it.
  template <int dim>
  std::vector<ConeGenerator<dim>>
  cone_of(const FaceShape<dim>               &shape,
          const MortarNode<dim>              &node,
          const std::vector<MortarFace<dim>> &faces);

  /// The vector M of a cone (all non-negative combinations of its generators)
  /// that is nearest to another one.
  template <int dim>
  struct NearestInCone
  {
    Tensor<1, dim>                  M;      ///< zero: the cone looks away
    std::vector<ConeGenerator<dim>> side;   ///< that M is on; empty: inside
    std::vector<double>             shares; ///< of those of the side in M
  };

  template <int dim>
  NearestInCone<dim>
  nearest_in_cone(const std::vector<ConeGenerator<dim>> &cone,
                  const Tensor<1, dim>                  &target);
} // namespace stickslip

#endif
