#include <stickslip/simulation/checkpoint.h>

#include <stickslip/base/user_error.h>

#include <stickslip/output/output_directory.h>

#include <stickslip/simulation/cell_records.h>
#include <stickslip/simulation/cell_state.h>
#include <stickslip/simulation/checkpoint_damage.h>
#include <stickslip/simulation/checkpoint_directory.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <vector>

namespace stickslip
{
  namespace
  {
    std::uint64_t
    new_identity()
    {
      std::random_device random;
      return (std::uint64_t(random()) << 32) ^ random();
    }



    /// The fields with the ghost entries that the own cells need.
    template <int dim>
    StateVectors
    with_ghosts(ContactProblem<dim> &problem,
                const AcceptedState &state,
                const ErrorEstimate *estimate)
    {
      const DofLayout<dim> &layout       = problem.layout();
      const auto           &multipliers  = problem.contact().multipliers();
      const MPI_Comm        communicator = problem.contact().get_communicator();
      StateVectors          fields;
      for (LA::Vector *field : {&fields.displacement,
                                &fields.nodal_forces,
                                &fields.contact_forces,
                                &fields.rate})
        field->reinit(layout.owned, layout.relevant, communicator);
      fields.multipliers.reinit(multipliers.locally_owned(),
                                multipliers.locally_relevant(),
                                communicator);
      fields.displacement   = state.x.block(0);
      fields.nodal_forces   = state.nodal_forces;
      fields.contact_forces = state.contact_forces;
      fields.rate           = state.rate;
      fields.multipliers    = state.x.block(1);
      fields.indicators.reinit(
        layout.dof_handler.get_triangulation().n_active_cells());
      if (estimate != nullptr)
        fields.indicators = estimate->indicators;
      return fields;
    }



    /// Numbers of all files, those next to where this rank stands first.
    std::vector<unsigned int>
    reading_order(const unsigned int n_files, const MPI_Comm &communicator)
    {
      const double place =
        (Utilities::MPI::this_mpi_process(communicator) + 0.5) /
        Utilities::MPI::n_mpi_processes(communicator) * n_files;
      std::vector<unsigned int> order(n_files);
      for (unsigned int i = 0; i < n_files; ++i)
        order[i] = i;
      std::stable_sort(order.begin(),
                       order.end(),
                       [place](const unsigned int a, const unsigned int b) {
                         return std::abs(a + 0.5 - place) <
                                std::abs(b + 0.5 - place);
                       });
      return order;
    }



    /// Reads the records of this rank's cells; returns what is damaged.
    template <int dim>
    std::string
    read_own_cells(const std::string           &checkpoint,
                   const CheckpointDescription &description,
                   ContactProblem<dim>         &problem,
                   StateVectors                &fields)
    {
      const MPI_Comm     communicator = problem.contact().get_communicator();
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      const PartitionFreeNames<dim> names(
        problem.layout().dof_handler.get_triangulation());
      std::map<CellKey, typename DoFHandler<dim>::active_cell_iterator> missing;
      for (const auto &cell :
           problem.layout().dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          missing.emplace(names.name_of(cell->id()), cell);

      CellState<dim>      state(problem);
      std::vector<double> record;
      for (const unsigned int n :
           reading_order(description.n_files, communicator))
        {
          // somebody opens every file, also those without any cells
          const bool is_mine = n % n_ranks == rank;
          if (missing.empty() && !is_mine)
            continue;
          const std::string file = path_of_cells(checkpoint, n);
          CellRecordReader  reader(file, description.identity);
          if (!reader.error().empty())
            return reader.error();
          for (unsigned int i = 0; i < reader.n_cells(); ++i)
            {
              const auto wanted = missing.find(reader.cell(i));
              if (wanted == missing.end())
                continue;
              if (!reader.read(i, record) ||
                  !state.read(wanted->second, record, fields))
                return "'" + file + "': its data are damaged";
              missing.erase(wanted);
            }
        }
      return missing.empty()
               ? ""
               : "its files lack " + std::to_string(missing.size()) + " cells";
    }
  } // namespace



  CheckpointDescription
  read_description(const std::string &directory,
                   const MPI_Comm    &communicator,
                   std::string       &checkpoint)
  {
    std::string error, text;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        checkpoint = find_checkpoint(directory, error);
        if (error.empty())
          {
            std::ifstream      file(path_of_description(checkpoint));
            std::ostringstream content;
            content << file.rdbuf();
            text = content.str();
            CheckpointDescription description;
            const std::string     other  = description.other_format(text);
            const std::string     damage = description.parse(text);
            if (!other.empty())
              error = "--restart: the checkpoint '" + checkpoint +
                      "' cannot be used: " + other + "." +
                      name_whole_checkpoint_beside(checkpoint);
            else if (!damage.empty())
              error = describe_damage(checkpoint, damage);
          }
      }
    throw_collectively(error, communicator);
    checkpoint = Utilities::MPI::broadcast(communicator, checkpoint, 0);
    text       = Utilities::MPI::broadcast(communicator, text, 0);
    CheckpointDescription description;
    description.parse(text);
    return description;
  }



  template <int dim>
  void
  save_checkpoint(const std::string       &directory,
                  ContactProblem<dim>     &problem,
                  const AcceptedState     &accepted,
                  const ErrorEstimate     *estimate,
                  const CheckpointScalars &scalars,
                  const ParameterValues   &physics)
  {
    const MPI_Comm        communicator = problem.contact().get_communicator();
    const unsigned int    rank = Utilities::MPI::this_mpi_process(communicator);
    CheckpointDescription description;
    description.problem = fingerprint(problem);
    description.n_files = Utilities::MPI::n_mpi_processes(communicator);
    description.scalars = scalars;
    description.scalars.energy_norm =
      estimate != nullptr ? estimate->energy_norm : -1.;
    description.physics = physics;
    std::string checkpoint, error;
    if (rank == 0)
      {
        error                = prepare_next_checkpoint(directory, checkpoint);
        description.identity = new_identity();
      }
    throw_collectively(error, communicator);
    checkpoint = Utilities::MPI::broadcast(communicator, checkpoint, 0);
    description.identity =
      Utilities::MPI::broadcast(communicator, description.identity, 0);

    const PartitionFreeNames<dim> names(
      problem.layout().dof_handler.get_triangulation());
    const StateVectors  fields = with_ghosts(problem, accepted, estimate);
    CellState<dim>      state(problem);
    CellRecordWriter    writer(path_of_cells(checkpoint, rank),
                            description.identity);
    std::vector<double> record;
    for (const auto &cell :
         problem.layout().dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          state.write(cell, fields, record);
          writer.add(names.name_of(cell->id()), record);
        }
    error = first_error(writer.finish(), communicator);
    if (error.empty() && rank == 0)
      error =
        declare_complete(checkpoint, description.text(), description.n_files);
    if (!error.empty() && rank == 0)
      error += name_whole_checkpoint_beside(checkpoint);
    throw_collectively(error, communicator);
  }



  template <int dim>
  CheckpointScalars
  load_checkpoint(const std::string   &directory,
                  ContactProblem<dim> &problem,
                  AcceptedState       &accepted,
                  Vector<double>      &indicators,
                  ParameterValues     &physics)
  {
    const MPI_Comm communicator = problem.contact().get_communicator();
    std::string    checkpoint;
    const CheckpointDescription description =
      read_description(directory, communicator, checkpoint);
    const std::string difference =
      fingerprint(problem).difference_from(description.problem);
    if (!difference.empty()) // the same on all ranks
      throw UserError("--restart: the checkpoint '" + checkpoint +
                      "' is of another case: " + difference + ".");

    accepted.x             = problem.zero_state();
    const LA::Vector &zero = accepted.x.block(0);
    const auto       &triangulation =
      problem.layout().dof_handler.get_triangulation();
    StateVectors fields{zero,
                        zero,
                        zero,
                        zero,
                        accepted.x.block(1),
                        Vector<double>(triangulation.n_active_cells())};
    std::string  damage =
      first_error(read_own_cells(checkpoint, description, problem, fields),
                  communicator);
    if (!damage.empty() && Utilities::MPI::this_mpi_process(communicator) == 0)
      damage = describe_damage(checkpoint, damage);
    throw_collectively(damage, communicator);
    for (LA::Vector *field : {&fields.displacement,
                              &fields.nodal_forces,
                              &fields.contact_forces,
                              &fields.rate,
                              &fields.multipliers})
      field->compress(VectorOperation::insert);
    accepted.x.block(0)     = fields.displacement;
    accepted.x.block(1)     = fields.multipliers;
    accepted.nodal_forces   = fields.nodal_forces;
    accepted.contact_forces = fields.contact_forces;
    accepted.rate           = fields.rate;
    indicators              = fields.indicators;
    problem.contact().share_sides();
    problem.restore(); // the state goes on from the accepted histories
    physics = description.physics;
    return description.scalars;
  }



#define INSTANTIATE(dim)                                                \
  template void              save_checkpoint(const std::string &,       \
                                             ContactProblem<dim> &,     \
                                             const AcceptedState &,     \
                                             const ErrorEstimate *,     \
                                             const CheckpointScalars &, \
                                             const ParameterValues &);  \
  template CheckpointScalars load_checkpoint(const std::string &,       \
                                             ContactProblem<dim> &,     \
                                             AcceptedState &,           \
                                             Vector<double> &,          \
                                             ParameterValues &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
