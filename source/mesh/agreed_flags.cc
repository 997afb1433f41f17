#include <stickslip/mesh/agreed_flags.h>

#include <stickslip/base/over_ranks.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// The levels that cells and their children will have, by active cell.
    using Levels = std::vector<int>;



    template <int dim>
    Levels
    wanted_levels(const Triangulation<dim> &triangulation)
    {
      Levels levels(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        levels[cell->active_cell_index()] = cell->level() +
                                            (cell->refine_flag_set() ? 1 : 0) -
                                            (cell->coarsen_flag_set() ? 1 : 0);
      return levels;
    }



    template <int dim>
    void
    send_to_ghosts(const Triangulation<dim> &triangulation, Levels &levels)
    {
      GridTools::exchange_cell_data_to_ghosts<int, Triangulation<dim>>(
        triangulation,
        [&levels](const auto &cell) {
          return std::optional<int>(levels[cell->active_cell_index()]);
        },
        [&levels](const auto &cell, const int level) {
          levels[cell->active_cell_index()] = level;
        });
    }



    /// Raises the levels of cells that would be more than one below those at
    /// their vertices. Returns whether there was any.
    template <int dim>
    bool
    raise_to_neighbours(const Triangulation<dim> &triangulation, Levels &levels)
    {
      std::vector<int> finest(triangulation.n_vertices(),
                              std::numeric_limits<int>::min());
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            {
              int &at_vertex = finest[cell->vertex_index(v)];
              at_vertex =
                std::max(at_vertex, levels[cell->active_cell_index()]);
            }
      bool any = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            {
              int &level = levels[cell->active_cell_index()];
              if (level < finest[cell->vertex_index(v)] - 1)
                {
                  level = finest[cell->vertex_index(v)] - 1;
                  any   = true;
                }
            }
      return any;
    }



    /// Keeps the cells that would be coarser without all their siblings.
    /// Returns whether there was any.
    template <int dim>
    bool
    keep_families(const Triangulation<dim> &triangulation, Levels &levels)
    {
      bool any = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          int &level = levels[cell->active_cell_index()];
          if (!cell->is_locally_owned() || level >= cell->level())
            continue;
          const auto parent    = cell->parent();
          bool       all_agree = true;
          for (unsigned int c = 0; c < parent->n_children(); ++c)
            all_agree = all_agree && parent->child(c)->is_active() &&
                        !parent->child(c)->is_artificial() &&
                        levels[parent->child(c)->active_cell_index()] <
                          parent->child(c)->level();
          if (!all_agree)
            {
              level = cell->level();
              any   = true;
            }
        }
      return any;
    }
  } // namespace



  template <int dim>
  bool
  agree_on_flags(parallel::distributed::Triangulation<dim> &triangulation)
  {
    Levels levels = wanted_levels(triangulation);
    for (bool any = true; any;)
      {
        send_to_ghosts(triangulation, levels);
        any = raise_to_neighbours(triangulation, levels);
        any = keep_families(triangulation, levels) || any;
        any = any_rank(any, triangulation.get_communicator());
      }
    bool any_flag = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
        if (!cell->is_locally_owned())
          continue;
        const int level = levels[cell->active_cell_index()];
        if (level > cell->level())
          cell->set_refine_flag();
        else if (level < cell->level())
          cell->set_coarsen_flag();
        any_flag = any_flag || level != cell->level();
      }
    return any_rank(any_flag, triangulation.get_communicator());
  }



  template <int dim>
  void
  execute_agreed_flags(parallel::distributed::Triangulation<dim> &triangulation)
  {
    agree_on_flags(triangulation);
    std::vector<bool> refine, coarsen;
    triangulation.save_refine_flags(refine);
    triangulation.save_coarsen_flags(coarsen);
    // before this signal deal.II changes flags by what one rank can see
    const auto connection =
      triangulation.signals.pre_distributed_refinement.connect([&]() {
        triangulation.load_refine_flags(refine);
        triangulation.load_coarsen_flags(coarsen);
      });
    triangulation.execute_coarsening_and_refinement();
    connection.disconnect();
  }

  template bool
  agree_on_flags(parallel::distributed::Triangulation<2> &);
  template bool
  agree_on_flags(parallel::distributed::Triangulation<3> &);
  template void
  execute_agreed_flags(parallel::distributed::Triangulation<2> &);
  template void
  execute_agreed_flags(parallel::distributed::Triangulation<3> &);
} // namespace stickslip
