#ifndef stickslip_contact_pairing_surface_borders_h
#define stickslip_contact_pairing_surface_borders_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <array>
#include <vector>

namespace stickslip
{
  /// From each side of the reference face; a triangle has one side less, from
  /// which everything is infinitely far.
  template <int dim>
  using SideDistances = std::array<double, 2 * (dim - 1)>;

  /// Of a point of the reference face, from each of its sides: 0 there, 1 at
  /// the nodes opposite.
  template <int dim>
  SideDistances<dim>
  distances_to_sides(const FaceShape<dim> &shape, const Point<dim - 1> &xi);

  /// The sides of the face that its node @p j lies on, as distances_to_sides()
  /// counts them.
  template <int dim>
  std::vector<unsigned int>
  sides_of_node(const FaceShape<dim> &shape, const unsigned int j);

  /// The borders of the faces around @p node at which the slave surface ends:
  /// no other of the faces has them, or lies beyond them.
  template <int dim>
  std::vector<typename MortarNode<dim>::Border>
  find_borders(const FaceShape<dim>               &shape,
               const MortarNode<dim>              &node,
               const std::vector<MortarFace<dim>> &faces);

  /**
   * Unit vector in the face, at its node @p j, that leads out of it across the
   * border from there to the node @p neighbour of the face (2D: @p j itself).
   * @p positions are those of the nodes of the face.
   */
  template <int dim>
  Tensor<1, dim>
  direction_out(const FaceShape<dim>              &shape,
                const SurfaceFace<dim>            &face,
                const unsigned int                 j,
                const unsigned int                 neighbour,
                const std::vector<Tensor<1, dim>> &positions);

  /// Derivative of direction_out() per node of the face.
  template <int dim>
  std::vector<Tensor<2, dim>>
  direction_out_derivative(const FaceShape<dim>              &shape,
                           const SurfaceFace<dim>            &face,
                           const unsigned int                 j,
                           const unsigned int                 neighbour,
                           const std::vector<Tensor<1, dim>> &positions);
} // namespace stickslip

#endif
