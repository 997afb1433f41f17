#ifndef stickslip_mesh_second_order_nodes_h
#define stickslip_mesh_second_order_nodes_h

#include <stickslip/mesh/file/mesh_file.h>
#include <stickslip/mesh/quadratic_cells.h>

#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// How far the nodes between the vertices are from where they would be in a
  /// straight cell.
  struct NodeDeviation
  {
    double   largest = 0.; ///< a length
    double   ratio   = 0.; ///< the largest one, over the way between vertices
    Point<3> place;        ///< of the node with the largest one

    /// False if all cells are straight up to roundoff.
    bool
    is_curved() const
    {
      return ratio > 1e-9;
    }
  };

  /// Of the @p cells (elements of @p file): triangles, quadrilaterals,
  /// tetrahedra or hexahedra. All deviations of elements of the first order
  /// are 0.
  NodeDeviation
  deviation_of_nodes(const MeshFile                 &file,
                     const std::vector<std::size_t> &cells);

  /**
   * The geometry of @p cells, which are of one kind; no pointer if all are
   * straight. Nodes that an element does not have, in the middles of faces and
   * cells (QUAD8, HEX20), get their place by transfinite interpolation, which
   * is what the shape functions of serendipity elements say.
   *
   * Throws UserError that begins with @p where if two cells have different
   * nodes on an edge or face that they share.
   */
  template <int dim>
  std::shared_ptr<QuadraticCells<dim>>
  curved_cells(const MeshFile                 &file,
               const std::vector<std::size_t> &cells,
               const std::string              &where);
} // namespace stickslip

#endif
