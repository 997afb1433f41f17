#include <stickslip/mesh/local_refinement.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/cell_layers.h>
#include <stickslip/mesh/refinement_rule.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// What @p rule wants refined from @p level on, with its buffer.
    template <int dim>
    CellFlags
    flags_of(const RefinementRule<dim> &rule,
             const unsigned int         level,
             const Triangulation<dim>  &triangulation)
    {
      CellFlags    flags(triangulation.n_active_cells(), false);
      unsigned int n_found = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && rule.concerns(cell))
          {
            flags[cell->active_cell_index()] = true;
            ++n_found;
          }
      if (Utilities::MPI::max(n_found, triangulation.get_communicator()) == 0)
        throw UserError(rule.request.path +
                        " refines nothing: no cell is where it says.");
      for (unsigned int i = 0; i < rule.request.parameters.buffer_layers; ++i)
        add_layer(triangulation, flags);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->level() != static_cast<int>(level))
          flags[cell->active_cell_index()] = false;
      return flags;
    }



    /// What the mesh will have at the end, at least: a cell that is all
    /// concerned is refined as often as its rule says, one with a flag once.
    template <int dim>
    double
    least_number_of_cells(const std::vector<RefinementRule<dim>> &rules,
                          const CellFlags                        &flags,
                          const unsigned int                      n_global,
                          const Triangulation<dim>               &triangulation)
    {
      double n = 0.;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            int missing = flags[cell->active_cell_index()] ? 1 : 0;
            for (const RefinementRule<dim> &rule : rules)
              {
                const int levels = n_global + rule.request.parameters.levels;
                if (levels - cell->level() > missing && rule.covers(cell))
                  missing = levels - cell->level();
              }
            n += std::ldexp(1., dim * missing);
          }
      return Utilities::MPI::sum(n, triangulation.get_communicator());
    }
  } // namespace



  template <int dim>
  void
  refine_locally(const std::vector<RefinementRequest>      &requests,
                 const Bodies                              &bodies,
                 const MeshSize                            &size,
                 const double                               bytes_per_cell,
                 parallel::distributed::Triangulation<dim> &triangulation)
  {
    const unsigned int n_global = triangulation.n_global_levels() - 1;
    unsigned int       n_levels = 0;
    std::string        path; // of the rule with most levels
    std::vector<RefinementRule<dim>> rules;
    for (const RefinementRequest &request : requests)
      {
        rules.emplace_back(request, bodies, triangulation, n_global);
        if (request.parameters.levels > n_levels)
          {
            n_levels = request.parameters.levels;
            path     = request.path;
          }
      }
    for (unsigned int i = 0; i < n_levels; ++i)
      {
        CellFlags flags(triangulation.n_active_cells(), false);
        for (const RefinementRule<dim> &rule : rules)
          if (rule.request.parameters.levels > i)
            {
              const CellFlags more =
                flags_of(rule, n_global + i, triangulation);
              for (unsigned int c = 0; c < flags.size(); ++c)
                flags[c] = flags[c] || more[c];
            }
        size.check_locally_refined(
          least_number_of_cells(rules, flags, n_global, triangulation),
          bytes_per_cell,
          path + "/Levels = " + std::to_string(n_levels));
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && flags[cell->active_cell_index()])
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
  }



  template <int dim>
  std::vector<types::global_cell_index>
  cells_by_level(const Triangulation<dim> &triangulation)
  {
    std::vector<types::global_cell_index> n(triangulation.n_global_levels(), 0);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        ++n[cell->level()];
    const auto of_this_rank = n;
    Utilities::MPI::sum(of_this_rank, triangulation.get_communicator(), n);
    return n;
  }



  std::vector<std::string>
  describe_levels(const std::vector<types::global_cell_index> &cells)
  {
    if (cells.empty())
      return {};
    types::global_cell_index sum = 0;
    std::string              levels;
    for (unsigned int level = 0; level < cells.size(); ++level)
      if (cells[level] > 0)
        {
          sum += cells[level];
          levels += (levels.empty() ? "level " : ", level ") +
                    std::to_string(level) + ": " + std::to_string(cells[level]);
        }
    return {"Mesh: " + std::to_string(sum) + " cells (" + levels + ")"};
  }

#define INSTANTIATE(dim)                                                     \
  template void refine_locally(const std::vector<RefinementRequest> &,       \
                               const Bodies &,                               \
                               const MeshSize &,                             \
                               const double,                                 \
                               parallel::distributed::Triangulation<dim> &); \
  template std::vector<types::global_cell_index> cells_by_level(             \
    const Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
