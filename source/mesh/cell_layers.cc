#include <stickslip/mesh/cell_layers.h>

#include <deal.II/grid/grid_tools.h>

#include <optional>

namespace stickslip
{
  namespace
  {
    template <int dim>
    void
    exchange_flags(const Triangulation<dim> &triangulation, CellFlags &flags)
    {
      GridTools::exchange_cell_data_to_ghosts<unsigned int, Triangulation<dim>>(
        triangulation,
        [&flags](const auto &cell) {
          return std::optional<unsigned int>(
            flags[cell->active_cell_index()] ? 1 : 0);
        },
        [&flags](const auto &cell, const unsigned int value) {
          flags[cell->active_cell_index()] = value > 0;
        });
    }
  } // namespace



  template <int dim>
  void
  add_layer(const Triangulation<dim> &triangulation, CellFlags &flags)
  {
    exchange_flags(triangulation, flags);
    std::vector<bool> is_marked(triangulation.n_vertices(), false);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (!cell->is_artificial() && flags[cell->active_cell_index()])
        for (const unsigned int v : cell->vertex_indices())
          is_marked[cell->vertex_index(v)] = true;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (is_marked[cell->vertex_index(v)])
            flags[cell->active_cell_index()] = true;
  }

  template void
  add_layer(const Triangulation<2> &, CellFlags &);
  template void
  add_layer(const Triangulation<3> &, CellFlags &);
} // namespace stickslip
