#ifndef stickslip_mesh_mesh_checks_h
#define stickslip_mesh_mesh_checks_h

#include <deal.II/grid/reference_cell.h>
#include <deal.II/grid/tria.h>

#include <string>
#include <utility>
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

  /// Says where faces of the boundary lie on each other, as along a crack with
  /// two sets of nodes, which a mesh generator also makes of two parts that it
  /// was not told to join; "" if there are none.
  template <int dim>
  std::string
  warning_about_seams(const Triangulation<dim> &triangulation,
                      const std::string        &path);

  /// Names of bodies and the cells that they are made of.
  using KindsOfCells = std::vector<std::pair<std::string, ReferenceCell>>;

  /// The cell that all bodies, one at least, are made of. Throws UserError if
  /// there are two.
  ReferenceCell
  common_cell(const KindsOfCells &kinds);
} // namespace stickslip

#endif
