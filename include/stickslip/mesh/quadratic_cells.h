#ifndef stickslip_mesh_quadratic_cells_h
#define stickslip_mesh_quadratic_cells_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/fe/fe.h>

#include <deal.II/grid/reference_cell.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * The geometry of a body that was read from a mesh of the second order, or
   * that `Coordinates` has bent: each cell is the image of the unit cell under
   * the polynomials of degree 2 (in each direction for quadrilaterals and
   * hexahedra) that have its nodes.
   *
   * It knows nothing of triangulations, and its cells stay what they are when
   * those of a triangulation are refined. All cells are kept on each rank, as
   * those of the coarse mesh are. Nothing is collective.
   */
  template <int dim>
  class QuadraticCells
  {
  public:
    explicit QuadraticCells(const ReferenceCell &cell);

    /// The element of degree 2, whose nodes are those of the cells.
    const FiniteElement<dim> &
    element() const
    {
      return *fe;
    }

    /// Appends a cell with the nodes of element(), in its order.
    void
    add(const std::vector<Point<dim>> &nodes);

    std::size_t
    size() const
    {
      return nodes.size() / fe->n_dofs_per_cell();
    }

    const Point<dim> &
    node(const std::size_t cell, const unsigned int i) const
    {
      return nodes[cell * fe->n_dofs_per_cell() + i];
    }

    /// Moves all nodes.
    void
    transform(const std::function<Point<dim>(const Point<dim> &)> &map);

    /// Where the point @p unit of the unit cell is.
    Point<dim>
    position(const std::size_t cell, const Point<dim> &unit) const;

    /// The gradients of the shape functions at a point of the unit cell, for
    /// places that are looked at in many cells.
    std::vector<Tensor<1, dim>>
    gradients(const Point<dim> &unit) const;

    /// The derivatives of position() where the shape functions have these
    /// gradients: jacobian[i][j] = dx_i / dunit_j.
    Tensor<2, dim>
    jacobian(const std::size_t                  cell,
             const std::vector<Tensor<1, dim>> &gradients) const;

    /// The point of the unit cell whose node is at @p x up to roundoff, if one
    /// is.
    std::optional<Point<dim>>
    unit_position_of_node(const std::size_t cell, const Point<dim> &x) const;

    /// The point of the unit cell that is at @p x, which position() gives back
    /// up to roundoff; nothing if @p x lies outside of the cell. Of a node it
    /// is exact.
    std::optional<Point<dim>>
    unit_position(const std::size_t cell, const Point<dim> &x) const;

    /// A box in which the cell certainly lies.
    BoundingBox<dim>
    box(const std::size_t cell) const;

  private:
    std::unique_ptr<FiniteElement<dim>> fe;
    std::vector<Point<dim>>             nodes; ///< cell after cell

    unsigned int
    nearest_node(const std::size_t cell, const Point<dim> &x) const;

    std::optional<Point<dim>>
    unit_position_from(const std::size_t cell,
                       const Point<dim> &x,
                       const Point<dim> &start) const;
  };
} // namespace stickslip

#endif
