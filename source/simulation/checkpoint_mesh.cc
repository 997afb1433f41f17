#include <stickslip/simulation/checkpoint_mesh.h>

#include <stickslip/base/over_ranks.h>
#include <stickslip/base/user_error.h>

#include <stickslip/mesh/agreed_flags.h>

#include <stickslip/simulation/cell_records.h>
#include <stickslip/simulation/cell_state.h>
#include <stickslip/simulation/checkpoint.h>
#include <stickslip/simulation/checkpoint_damage.h>
#include <stickslip/simulation/checkpoint_directory.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/grid/cell_id.h>

#include <map>
#include <set>

namespace stickslip
{
  namespace
  {
    /// p4est has no more levels.
    constexpr unsigned int most_passes = 64;



    /// The cell of this rank that @p id is, or that it is a part of.
    template <typename Cells>
    typename Cells::const_iterator
    find_cell_or_ancestor(const Cells &cells, const CellId &id)
    {
      const auto path = id.get_child_indices();
      for (unsigned int n = path.size() + 1; n-- > 0;)
        {
          const auto found =
            cells.find(CellId(id.get_coarse_cell_id(), n, path.data()));
          if (found != cells.end())
            return found;
        }
      return cells.end();
    }



    /// Flags the cells of this rank that are not those of the @p n_files files:
    /// too coarse, or too fine. Returns what is damaged.
    template <int dim>
    std::string
    flag_other_cells(const std::string                         &checkpoint,
                     const CheckpointDescription               &description,
                     parallel::distributed::Triangulation<dim> &triangulation)
    {
      using Cell = typename Triangulation<dim>::active_cell_iterator;
      const PartitionFreeNames<dim> names(triangulation);
      std::map<CellId, Cell>        cells;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          cells.emplace(cell->id(), cell);
      const std::size_t n_coarse =
        triangulation.get_p4est_tree_to_coarse_cell_permutation().size();
      std::set<CellId> are_not_too_fine;
      for (unsigned int n = 0; n < description.n_files; ++n)
        {
          const CellRecordReader reader(path_of_cells(checkpoint, n),
                                        description.identity);
          if (!reader.error().empty())
            return reader.error();
          for (unsigned int i = 0; i < reader.n_cells(); ++i)
            {
              CellKey key = reader.cell(i);
              if (key[0] >= n_coarse)
                continue; // of another case, as will be seen
              key[0] = names.coarse_id(key[0]);
              const CellId wanted(key);
              const auto   found = find_cell_or_ancestor(cells, wanted);
              if (found == cells.end())
                continue;
              are_not_too_fine.insert(found->first);
              if (found->first != wanted)
                found->second->set_refine_flag();
            }
        }
      for (const auto &[id, cell] : cells)
        if (are_not_too_fine.count(id) == 0)
          cell->set_coarsen_flag();
      return "";
    }



    template <int dim>
    bool
    has_flags(const parallel::distributed::Triangulation<dim> &triangulation)
    {
      bool any = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        any = any || (cell->is_locally_owned() &&
                      (cell->refine_flag_set() || cell->coarsen_flag_set()));
      return any_rank(any, triangulation.get_communicator());
    }


    bool
    is_of_adapted_mesh(const CheckpointDescription &description)
    {
      return description.scalars.adaptation.adaptations > 0;
    }
  } // namespace



  bool
  is_of_adapted_mesh(const std::string &directory, const MPI_Comm &communicator)
  {
    std::string checkpoint;
    return is_of_adapted_mesh(
      read_description(directory, communicator, checkpoint));
  }



  template <int dim>
  bool
  adopt_mesh(const std::string                           &directory,
             parallel::DistributedTriangulationBase<dim> &triangulation)
  {
    const MPI_Comm              communicator = triangulation.get_communicator();
    std::string                 checkpoint;
    const CheckpointDescription description =
      read_description(directory, communicator, checkpoint);
    if (!is_of_adapted_mesh(description))
      return false;
    auto *p4est =
      dynamic_cast<parallel::distributed::Triangulation<dim> *>(&triangulation);
    if (p4est == nullptr)
      throw UserError("--restart: the checkpoint '" + checkpoint +
                      "' is of an adapted mesh, which 'Mesh/Partitioner = "
                      "p4est' has to distribute.");
    for (unsigned int pass = 0; pass < most_passes; ++pass)
      {
        std::string damage =
          first_error(flag_other_cells(checkpoint, description, *p4est),
                      communicator);
        if (!damage.empty() &&
            Utilities::MPI::this_mpi_process(communicator) == 0)
          damage = describe_damage(checkpoint, damage);
        throw_collectively(damage, communicator);
        if (!has_flags(*p4est))
          break;
        execute_agreed_flags(*p4est);
      }
    return true;
  }

  template bool
  adopt_mesh(const std::string &, parallel::DistributedTriangulationBase<2> &);
  template bool
  adopt_mesh(const std::string &, parallel::DistributedTriangulationBase<3> &);
} // namespace stickslip
