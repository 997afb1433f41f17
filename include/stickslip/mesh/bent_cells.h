#ifndef stickslip_mesh_bent_cells_h
#define stickslip_mesh_bent_cells_h

#include <stickslip/mesh/quadratic_cells.h>

#include <deal.II/grid/tria.h>

#include <memory>

namespace stickslip
{
  using namespace dealii;

  /// The active cells, in their order, as cells of degree 2 that have their
  /// nodes on the manifolds of the triangulation.
  template <int dim>
  std::shared_ptr<QuadraticCells<dim>>
  quadratic_cells_of(const Triangulation<dim> &triangulation);

  /**
   * Whether the body of @p cells, which are the active cells of
   * @p triangulation in their order, has the boundary that straight cells
   * between their vertices have, to roundoff. Where points lie along it does
   * not matter.
   */
  template <int dim>
  bool
  has_straight_boundary(const Triangulation<dim>  &triangulation,
                        const QuadraticCells<dim> &cells);
} // namespace stickslip

#endif
