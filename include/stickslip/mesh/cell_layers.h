#ifndef stickslip_mesh_cell_layers_h
#define stickslip_mesh_cell_layers_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// One per active cell (active_cell_index). A rank decides on those of its
  /// own cells.
  using CellFlags = std::vector<bool>;

  /// Flags the cells of this rank that share a vertex with a flagged one, of
  /// any rank; the flags of ghost cells become those of their owners before.
  /// Collective.
  template <int dim>
  void
  add_layer(const Triangulation<dim> &triangulation, CellFlags &flags);
} // namespace stickslip

#endif
