#include <stickslip/mesh/cell_partition.h>

#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <metis.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Cells and their neighbours, as METIS reads them.
    struct CellGraph
    {
      std::vector<idx_t> starts = {0};
      std::vector<idx_t> neighbours;

      template <int dim>
      explicit CellGraph(const Triangulation<dim> &mesh)
      {
        DynamicSparsityPattern connectivity;
        GridTools::get_face_connectivity_of_cells(mesh, connectivity);
        for (unsigned int cell = 0; cell < connectivity.n_rows(); ++cell)
          {
            for (auto entry = connectivity.begin(cell);
                 entry != connectivity.end(cell);
                 ++entry)
              if (entry->column() != cell)
                neighbours.push_back(entry->column());
            starts.push_back(neighbours.size());
          }
      }
    };
  } // namespace



  template <int dim>
  void
  partition_cells(const unsigned int                            n_ranks,
                  const std::vector<std::vector<unsigned int>> &costs,
                  Triangulation<dim>                           &mesh)
  {
    CellGraph graph(mesh);
    idx_t     n_cells  = mesh.n_active_cells();
    idx_t     n_phases = costs.size();
    // with more parts than cells METIS gives all cells to one
    idx_t              n_parts = std::min<idx_t>(n_ranks, n_cells);
    std::vector<idx_t> weights; // [cell][phase]
    for (idx_t cell = 0; cell < n_cells; ++cell)
      for (const auto &cost : costs)
        weights.push_back(cost[cell]);

    std::vector<idx_t> ranks(n_cells, 0);
    if (n_parts > 1)
      {
        // As METIS' manual has it, of few parts recursive bisection is better.
        const auto partition =
          n_parts <= 8 ? METIS_PartGraphRecursive : METIS_PartGraphKway;
        idx_t     n_cut_faces;
        const int answer = partition(&n_cells,
                                     &n_phases,
                                     graph.starts.data(),
                                     graph.neighbours.data(),
                                     weights.data(),
                                     nullptr,
                                     nullptr,
                                     &n_parts,
                                     nullptr,
                                     nullptr,
                                     nullptr,
                                     &n_cut_faces,
                                     ranks.data());
        AssertThrow(answer == METIS_OK, SparsityTools::ExcMETISError(answer));
      }
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_subdomain_id(ranks[cell->active_cell_index()]);
  }



  template void
  partition_cells<2>(const unsigned int,
                     const std::vector<std::vector<unsigned int>> &,
                     Triangulation<2> &);
  template void
  partition_cells<3>(const unsigned int,
                     const std::vector<std::vector<unsigned int>> &,
                     Triangulation<3> &);
} // namespace stickslip
