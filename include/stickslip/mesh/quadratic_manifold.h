#ifndef stickslip_mesh_quadratic_manifold_h
#define stickslip_mesh_quadratic_manifold_h

#include <stickslip/mesh/quadratic_cells.h>

#include <deal.II/grid/manifold.h>

#include <deal.II/numerics/rtree.h>

#include <memory>
#include <utility>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * The manifold of a body with curved cells: new points are means in the unit
   * cell of the quadratic cell in which all surrounding points lie. So the
   * nodes of an isoparametric mapping of degree 2 are those of the cells, and
   * children of a cell, of any level, make up the same curved cell.
   *
   * Manifolds know points only, so that the cell is searched for. Where
   * several cells have the points, on faces and edges, all give the same.
   */
  template <int dim>
  class QuadraticManifold : public Manifold<dim, dim>
  {
  public:
    explicit QuadraticManifold(
      const std::shared_ptr<const QuadraticCells<dim>> &cells);

    /// Shares the cells.
    std::unique_ptr<Manifold<dim, dim>>
    clone() const override;

    Point<dim>
    get_new_point(const ArrayView<const Point<dim>> &surrounding_points,
                  const ArrayView<const double>     &weights) const override;

    void
    get_new_points(const ArrayView<const Point<dim>> &surrounding_points,
                   const Table<2, double>            &weights,
                   ArrayView<Point<dim>> new_points) const override;

  private:
    using BoxOfCell = std::pair<BoundingBox<dim>, unsigned int>;

    std::shared_ptr<const QuadraticCells<dim>> cells;
    std::shared_ptr<const RTree<BoxOfCell>>    boxes;

    /// A cell, and points in its unit cell.
    struct UnitPoints
    {
      std::size_t             cell;
      std::vector<Point<dim>> points;
    };

    /// Throws if there is no cell that has all of them.
    UnitPoints
    in_unit_cell(const ArrayView<const Point<dim>> &points) const;
  };
} // namespace stickslip

#endif
