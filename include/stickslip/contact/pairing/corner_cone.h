#ifndef stickslip_contact_pairing_corner_cone_h
#define stickslip_contact_pairing_corner_cone_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <optional>
#include <vector>

namespace stickslip
{
  /**
   * Finds the nodes at which the slave surface ends or has an edge, the
   * undeformed normals of two of their faces differing by more than
   * `sharpest_smooth_kink`. Sets is_corner and borders of the nodes.
   */
  template <int dim>
  void
  find_corners(const FaceShape<dim>               &shape,
               const std::vector<MortarFace<dim>> &faces,
               std::vector<MortarNode<dim>>       &nodes);

  /**
   * Decides anew about a corner that is on symmetry planes (its projection).
   * The surface goes on behind them: it does not end there, and its cone of
   * normals, of which the other half is the mirror image, has in a plane what
   * its generators have there. In the line of two planes there is no choice of
   * normals left.
   */
  template <int dim>
  void
  restrict_to_symmetry_planes(const FaceShape<dim>               &shape,
                              const std::vector<MortarFace<dim>> &faces,
                              MortarNode<dim>                    &node);

  /// A unit vector at a node: the normal of a face around it, or the direction
  /// in which the surface ends with the face (direction_out()), in the symmetry
  /// planes of the node.
  template <int dim>
  struct ConeGenerator
  {
    Tensor<1, dim>              direction;
    unsigned int                around = 0; ///< number of the face
    std::optional<unsigned int> neighbour;  ///< of a border: its other node
  };

  /// What spans the cone of normals of a corner in the present configuration:
  /// the normals of the faces around it, and the directions in which the
  /// surface ends.
  template <int dim>
  std::vector<ConeGenerator<dim>>
  cone_of(const FaceShape<dim>               &shape,
          const MortarNode<dim>              &node,
          const std::vector<MortarFace<dim>> &faces);

  /// Derivative of the direction per node of its face.
  template <int dim>
  std::vector<Tensor<2, dim>>
  generator_derivative(const FaceShape<dim>               &shape,
                       const MortarNode<dim>              &node,
                       const std::vector<MortarFace<dim>> &faces,
                       const ConeGenerator<dim>           &generator);

  /// The vector M of a cone (all non-negative combinations of its generators)
  /// that is nearest to another one.
  template <int dim>
  struct NearestInCone
  {
    Tensor<1, dim>                  M;     ///< zero: the cone looks away
    std::vector<ConeGenerator<dim>> side;  ///< that M is on; empty: inside
    std::vector<Tensor<1, dim>>     duals; ///< of the side, in its span
  };

  template <int dim>
  NearestInCone<dim>
  nearest_in_cone(const std::vector<ConeGenerator<dim>> &cone,
                  const Tensor<1, dim>                  &target);
} // namespace stickslip

#endif
