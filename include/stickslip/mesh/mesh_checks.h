#ifndef stickslip_mesh_mesh_checks_h
#define stickslip_mesh_mesh_checks_h

#include <stickslip/mesh/quadratic_cells.h>

#include <deal.II/grid/tria.h>

#include <cstddef>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// "(1, 2.5)"
  template <int dim>
  std::string
  coordinates_in_message(const Point<dim> &point);

  /// Throws UserError if @p triangulation has no cells or cells that are not
  /// all quadrilaterals (hexahedra) or all triangles (tetrahedra). @p path names
  /// the culprit.
  template <int dim>
  void
  check_cell_types(const Triangulation<dim> &triangulation,
                   const std::string        &path);

  /// Throws UserError naming the first inverted or degenerate active cell: one
  /// whose Jacobian determinant at a vertex is not positive.
  template <int dim>
  void
  check_cell_shapes(const Triangulation<dim> &triangulation,
                    const std::string        &path);

  /// Curved cells that their nodes turn inside out: whose Jacobian determinant
  /// is negative somewhere, or zero inside.
  template <int dim>
  struct CellsInsideOut
  {
    std::size_t n_cells = 0;
    std::size_t first   = 0; ///< index of the first one
    Point<dim>  place;       ///< where it is worst
  };

  template <int dim>
  CellsInsideOut<dim>
  cells_inside_out(const QuadraticCells<dim> &cells);

  /// Throws UserError naming the first of them, if there are any.
  template <int dim>
  void
  check_curved_cells(const QuadraticCells<dim> &cells, const std::string &path);

  /// Says where faces of the boundary lie on each other, as along a crack with
  /// two sets of nodes, which a mesh generator also makes of two parts that it
  /// was not told to join; "" if there are none.
  template <int dim>
  std::string
  warning_about_seams(const Triangulation<dim> &triangulation,
                      const std::string        &path);

  /// Says what elements of degree 1 make of @p bodies with curved cells.
  std::string
  warning_about_straight_sides(const std::vector<std::string> &bodies);
} // namespace stickslip

#endif
