#include <stickslip/simulation/mesh_adaptation.h>

#include <stickslip/adaptivity/refinement_marking.h>

#include <stickslip/base/short_number.h>

#include <stickslip/mesh/agreed_flags.h>
#include <stickslip/mesh/local_refinement.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// The mesh becomes coarser for its own sake if that many of its cells may:
    /// each new mesh costs a transfer and an equilibrium.
    constexpr double worthwhile_share_of_coarse_cells = 0.1;



    /// Where the whole error is below the target, cells become finer if they
    /// have more than that of the square of the target, all together.
    constexpr double worthwhile_share_of_the_target = 0.05;

    /// Levels by which a cell may become finer for what one estimate says: on
    /// cells as large as the contact it is too uncertain for more.
    constexpr unsigned int most_levels_of_an_estimate = 3;



    /// A step with more than so many times the error of all before it is
    /// another first step: what was strained until then, by a weak spring or by
    /// gravity, is not what the case is about. (Loads that grow from nothing in
    /// equal steps have twice the error in the second one, contact between
    /// curved bodies three times.)
    constexpr double jump_of_error = 5.;

    /// Meshes are made for the error of the state before: estimates are often a
    /// little larger than the target.
    constexpr double excess_worth_a_warning = 1.25;



    /// Largest change of a force, over the largest force.
    template <int dim>
    double
    relative_change(const std::vector<ContactResultants<dim>> &before,
                    const std::vector<ContactResultants<dim>> &now)
    {
      double change = 0., largest = 0.;
      for (unsigned int p = 0; p < now.size(); ++p)
        {
          const Tensor<1, dim> old =
            before[p].normal_force + before[p].friction_force;
          const Tensor<1, dim> present =
            now[p].normal_force + now[p].friction_force;
          change  = std::max(change, (present - old).norm());
          largest = std::max({largest, old.norm(), present.norm()});
        }
      return largest > 0. ? change / largest : 0.;
    }
  } // namespace



  template <int dim>
  MeshAdaptation<dim>::MeshAdaptation(const AdaptationParameters &parameters,
                                      Mesh<dim>                  &mesh)
    : parameters(parameters)
    , error(parameters)
    , mesh(mesh)
    , p4est(dynamic_cast<parallel::distributed::Triangulation<dim> *>(
        mesh.triangulation.get()))
  {}



  template <int dim>
  void
  MeshAdaptation<dim>::begin_step()
  {
    repetitions = 0;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::make_estimate(ContactProblem<dim>   &problem,
                                     const LA::BlockVector &x)
  {
    problem.residual(x); // what estimators look at
    error.update(problem, x);
  }



  template <int dim>
  typename MeshAdaptation<dim>::Flagged
  MeshAdaptation<dim>::mark(const ErrorEstimate &estimate)
  {
    mark_cells(estimate, parameters, mesh.bodies, *p4est);
    Flagged flagged;
    for (const auto &cell : p4est->active_cell_iterators())
      if (cell->is_locally_owned())
        {
          if (cell->refine_flag_set())
            {
              flagged.refined += 1.;
              flagged.error_of_refined +=
                estimate.indicators[cell->active_cell_index()];
            }
          flagged.coarsened += cell->coarsen_flag_set() ? 1. : 0.;
        }
    const MPI_Comm communicator = p4est->get_communicator();
    return {Utilities::MPI::sum(flagged.refined, communicator),
            Utilities::MPI::sum(flagged.error_of_refined, communicator),
            Utilities::MPI::sum(flagged.coarsened, communicator)};
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::should_be_finer(const Flagged &flagged) const
  {
    const ErrorEstimate &estimate = *error.get();
    if (!estimate.says_something())
      return false;
    if (estimate.is_rule || parameters.marking != Marking::error_target)
      return flagged.refined > 0.;
    const double target = parameters.error_target * estimate.energy_norm;
    return flagged.refined > 0. &&
           (estimate.error > target ||
            flagged.error_of_refined >
              worthwhile_share_of_the_target * target * target);
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::is_first_of_its_kind() const
  {
    return !done.has_begun || repetitions > 0 ||
           error.get()->error > jump_of_error * done.largest_error;
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::wants_repetition(ContactProblem<dim>   &problem,
                                        const LA::BlockVector &x)
  {
    if (!is_active() || parameters.repetition == Repetition::never ||
        repetitions == parameters.most_repetitions)
      return false;
    const bool is_every = parameters.repetition == Repetition::every_step;
    if (!is_every && done.has_begun && error.is_of_rule())
      return false;
    levels = 1;
    make_estimate(problem, x);
    if (!is_every && !is_first_of_its_kind())
      return false;
    const bool is_wanted = should_be_finer(mark());
    repetitions += is_wanted ? 1 : 0;
    return is_wanted;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::accept_step(ContactProblem<dim>   &problem,
                                   const LA::BlockVector &x)
  {
    error.update(problem, x);
    if (!is_active())
      return;
    done.has_begun |= error.get()->marks_something();
    if (!error.is_of_rule())
      done.largest_error = std::max(done.largest_error, error.get()->error);
  }



  template <int dim>
  std::vector<std::string>
  MeshAdaptation<dim>::warnings_of_step()
  {
    const ErrorEstimate *estimate = error.get();
    const bool           is_fixed =
      parameters.every == 0 && parameters.repetition == Repetition::never;
    if (estimate == nullptr || estimate->is_rule || is_fixed || has_warned ||
        !estimate->says_something() ||
        parameters.marking != Marking::error_target ||
        estimate->relative() < excess_worth_a_warning * parameters.error_target)
      return {};
    const KeptCoarse kept =
      find_kept_coarse(*estimate, parameters, mesh.bodies, *p4est);
    const double much = 0.5 * estimate->error * estimate->error;
    if (kept.by_levels < much && kept.by_cells < much)
      return {}; // the mesh has yet to follow
    has_warned = true;
    std::ostringstream text;
    text << "the estimated error is " << percent(estimate->relative())
         << " of the energy norm of the state, 'Adaptation/Error target' is "
         << percent(parameters.error_target) << ": "
         << (kept.by_levels >= much
               ? "'Most levels' = " + std::to_string(parameters.most_levels)
               : "'Most cells' = " + std::to_string(parameters.most_cells))
         << " keeps cells from becoming finer. Allow more, or a larger error.";
    return {text.str()};
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::wants_other_mesh(const unsigned int step)
  {
    if (error.get() == nullptr || !error.get()->says_something() ||
        parameters.every == 0 || step == 0 || step % parameters.every > 0)
      return false;
    levels                  = 1;
    const Flagged wanted    = mark();
    const bool    is_wanted = should_be_finer(wanted) ||
                           wanted.coarsened > worthwhile_share_of_coarse_cells *
                                                p4est->n_global_active_cells();
    // cells become coarser with all their siblings only: perhaps none does
    return is_wanted && agree_on_flags(*p4est);
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::expects_finer(const Vector<double> &expected)
  {
    const ErrorEstimate *estimate = error.get();
    if (estimate == nullptr || estimate->is_rule ||
        parameters.marking != Marking::error_target ||
        levels == most_levels_of_an_estimate)
      return false;
    ++levels;
    const bool is_wanted = mark(estimate_of(expected,
                                            /*is_rule=*/false,
                                            estimate->energy_norm,
                                            p4est->get_communicator()))
                             .refined > 0.;
    clear_coarsen_flags();
    return is_wanted;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::clear_coarsen_flags()
  {
    for (const auto &cell : p4est->active_cell_iterators())
      cell->clear_coarsen_flag();
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::wants_another_level(ContactProblem<dim>   &problem,
                                           const LA::BlockVector &x)
  {
    error.forget(); // it was of the old mesh
    if (!error.is_of_rule() || levels == parameters.most_levels)
      return false;
    ++levels;
    make_estimate(problem, x);
    const bool is_wanted = mark().refined > 0.;
    error.forget();        // the mesh has been adapted to the state
    clear_coarsen_flags(); // they will be, after the next step
    return is_wanted;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::resume(const CheckpointScalars &scalars,
                              const Vector<double>    &indicators,
                              const bool               is_same,
                              ContactProblem<dim>     &problem,
                              const LA::BlockVector   &x)
  {
    done = scalars.adaptation;
    if (is_active() && !is_same)
      make_estimate(problem, x);
    else if (is_active() && scalars.energy_norm >= 0.)
      error.resume(indicators, scalars.energy_norm, p4est->get_communicator());
    done.has_begun &= is_same;
    if (!is_same)
      done.largest_error = 0.;
  }



  template <int dim>
  std::string
  MeshAdaptation<dim>::record_new_mesh(const double residual)
  {
    ++done.adaptations;
    mesh.cells_by_level = cells_by_level(*p4est);
    transfer_residual   = std::max(transfer_residual, residual);
    return describe_levels(mesh.cells_by_level).front();
  }



  template <int dim>
  std::string
  MeshAdaptation<dim>::record_equilibrium(
    const unsigned int                         iterations,
    const std::vector<ContactResultants<dim>> &before,
    const std::vector<ContactResultants<dim>> &now)
  {
    transfer_iterations += iterations;
    const double change = relative_change(before, now);
    force_change        = std::max(force_change, change);
    std::ostringstream text;
    text << "equilibrium on the new mesh: " << iterations
         << " Newton iterations, contact forces changed by " << percent(change);
    return text.str();
  }



  template <int dim>
  void
  MeshAdaptation<dim>::add_to(StatisticsTable &statistics)
  {
    if (!is_active())
      return;
    statistics.add("cells",
                   static_cast<double>(p4est->n_global_active_cells()));
    statistics.add("adaptations", done.adaptations);
    statistics.add("repetitions", repetitions);
    statistics.add("transfer_iterations", transfer_iterations);
    statistics.add("transfer_residual", transfer_residual);
    statistics.add("transfer_force_change", force_change);
    error.add_to(statistics);
    transfer_iterations = 0;
    transfer_residual   = 0.;
    force_change        = 0.;
  }

  template class MeshAdaptation<2>;
  template class MeshAdaptation<3>;
} // namespace stickslip
