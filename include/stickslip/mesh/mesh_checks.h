#ifndef stickslip_mesh_mesh_checks_h
#define stickslip_mesh_mesh_checks_h

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Throws UserError if @p triangulation has no cells or cells that are no
  /// quadrilaterals or hexahedra. @p path names the culprit.
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
} // namespace stickslip

#endif
