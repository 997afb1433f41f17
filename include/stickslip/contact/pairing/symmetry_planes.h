#ifndef stickslip_contact_pairing_symmetry_planes_h
#define stickslip_contact_pairing_symmetry_planes_h

#include <stickslip/base/types.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// The unit vectors along which @p supports (closed) hold the node that begins
  /// with dof @p first, turned by @p rotation; none if it cannot move at all.
  template <int dim>
  std::vector<Tensor<1, dim>>
  held_directions(const types::global_dof_index first,
                  const Tensor<2, dim>         &rotation,
                  const Constraints            &supports);

  /**
   * The projection onto the symmetry planes that a node of a surface lies on.
   * A plane is one if the node cannot move across it (@p supports, closed), and
   * if the facets around it are all on one side of it. A node that cannot move
   * at all tells nothing: the identity.
   *
   * @p positions: undeformed, of the nodes of these facets; the node is number
   * @p own among them, moves with the displacements from @p first on, turned by
   * @p rotation.
   */
  template <int dim>
  Tensor<2, dim>
  symmetry_projection(const std::vector<Point<dim>> &positions,
                      const unsigned int             own,
                      const types::global_dof_index  first,
                      const Tensor<2, dim>          &rotation,
                      const Constraints             &supports);
} // namespace stickslip

#endif
