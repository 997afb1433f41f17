#include <stickslip/simulation/simulation.h>

#include <stickslip/base/no_convergence.h>
#include <stickslip/base/user_error.h>

#include <stickslip/contact/results/contact_results.h>

#include <stickslip/output/diagnosis_output.h>
#include <stickslip/output/output_directory.h>

#include <stickslip/simulation/checkpoint.h>
#include <stickslip/simulation/checkpoint_directory.h>
#include <stickslip/simulation/final_results.h>

#include <iostream>
#include <sstream>

namespace stickslip
{
  template <int dim>
  Simulation<dim>::Simulation(const CaseParameters &parameters,
                              const MPI_Comm       &communicator)
    : parameters(parameters)
    , communicator(communicator)
    , mesh(build_mesh<dim>(parameters.mesh,
                           parameters.bodies,
                           parameters.periodic_requests(),
                           communicator,
                           parameters.slave_surfaces()))
    , problem(mesh,
              parameters.degree,
              parameters.materials,
              parameters.boundary_conditions,
              parameters.contact_pairs,
              parameters.algorithm.tangent == Tangent::quasi)
    , linear_solver(create_linear_solver(parameters.linear_solver))
    , step_control(parameters.load_stepping,
                   fallback_sequence(parameters.algorithm.name,
                                     !parameters.contact_pairs.empty()),
                   parameters.algorithm.newton.max_iterations)
    , x(problem.zero_state())
    , accepted{x, x.block(0), x.block(0)}
    , warnings(parameters.contact_pairs)
    , field_output(parameters.output, mesh.bodies, communicator)
    , contact_output(parameters.output, communicator)
    , point_values(parameters.output, mesh.bodies, communicator)
    , statistics(parameters.output.directory + "/statistics", communicator)
    , force_tables(parameters, communicator)
    , log(parameters.output.directory, communicator)
    , step_solver(parameters, problem, *linear_solver, log)
    , progress(parameters.output.verbosity,
               0.,
               parameters.load_stepping.end_time,
               communicator)
  {
    problem.solid().stabilization().activate(
      parameters.load_stepping.stabilization_factor,
      parameters.load_stepping.end_time);
    problem.check_bodies_are_held();
    point_values.locate(problem.layout().mapping, problem.layout().dof_handler);
  }



  template <int dim>
  unsigned int
  Simulation<dim>::run(const std::string &restart_from)
  {
    log.open(!restart_from.empty());
    for (const std::string &text : warnings.of_parameters())
      warn(text);
    if (!restart_from.empty())
      resume(restart_from);
    else if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        retire_checkpoints(parameters.output.directory);
        remove_diagnoses(parameters.output.directory);
      }
    while (!steps().finished())
      {
        begin_step();
        while (!solve_step())
          {}
        accept_step();
      }
    log.note("done: " + std::to_string(steps().step_number()) + " steps");
    progress.finished(steps().step_number());
    return report_final_results();
  }



  template <int dim>
  void
  Simulation<dim>::begin_step()
  {
    step_control.begin_step();
    step_solver.begin_step();
  }



  template <int dim>
  LA::BlockVector
  Simulation<dim>::predict() const
  {
    LA::BlockVector predicted(accepted.x);
    predicted.block(0).add(steps().next_time() - steps().time(), accepted.rate);
    return predicted;
  }



  template <int dim>
  bool
  Simulation<dim>::solve_step()
  {
    const double time = steps().next_time();
    const double size = time - steps().time();
    problem.solid().stabilization().begin_step(size);
    log.begin_step(steps().step_number() + 1, time, size);
    try
      {
        solved =
          step_solver.solve(time, accepted.x, predict(), step_control, x);
      }
    catch (const NoConvergence &failure)
      {
        cut_step(failure);
        return false;
      }
    return true;
  }



  template <int dim>
  void
  Simulation<dim>::accept_step()
  {
    problem.accept_step(x);
    // trapezoidal rule for the work of loads and supports
    LA::Vector step(x.block(0));
    step -= accepted.x.block(0);
    work.external +=
      0.5 * (accepted.nodal_forces * step + problem.nodal_forces() * step);
    work.stabilization +=
      problem.solid().stabilization_work(problem.ghosted_displacement());
    accepted.nodal_forces = problem.nodal_forces();
    accepted.x            = x;
    accepted.rate         = step;
    accepted.rate *= 1. / (steps().next_time() - steps().time());
    step_control.accept_step(solved, problem.counts.newton_iterations);

    const auto faces = contact_results(problem.contact());
    const auto resultants =
      compute_contact_resultants(faces,
                                 parameters.contact_pairs.size(),
                                 communicator);
    for (const auto &pair : resultants)
      work.friction -= pair.friction_work;
    for (const std::string &text : warnings.of_step(resultants))
      warn(text);
    write_statistics();
    force_tables.write(steps().step_number(),
                       steps().time(),
                       resultants,
                       problem.reactions());
    write_results(faces);
    progress.accepted_step(steps().step_number(),
                           steps().time(),
                           name_of(solved.algorithm) + ", " +
                             std::to_string(problem.counts.newton_iterations) +
                             " Newton iterations");
  }



  template <int dim>
  void
  Simulation<dim>::cut_step(const NoConvergence &failure)
  {
    const FailureReport report =
      report_failure(failure,
                     steps().step_number() + 1,
                     parameters,
                     problem,
                     step_solver.cycle_treatment.history(),
                     log.last_newton_run());
    log.note(report.text());
    problem.restore();
    x = accepted.x;
    if (!steps().can_be_cut())
      stop(failure, report);
    const double tried = steps().next_time();
    step_control.cut_step();
    progress.rejected_step(tried, failure.what(), steps().step_size());
  }



  template <int dim>
  void
  Simulation<dim>::stop(const NoConvergence &failure,
                        const FailureReport &report)
  {
    const std::string last =
      steps().describe_last_step() + ": " + failure.what();
    step_control.cut_step(); // a run that goes on begins with a smaller step
    std::string state = "Continue it with --restart latest.";
    try
      {
        write_checkpoint();
      }
    catch (const UserError &error)
      {
        state = error.what();
      }
    const std::string text = report.final_text(last, steps().time(), state);
    log.note("stopped: " + text);
    throw NoConvergence(text, failure);
  }



  template <int dim>
  void
  Simulation<dim>::write_results(
    const std::vector<ContactFaceResult<dim>> &faces)
  {
    const unsigned int        step = steps().step_number();
    const double              time = steps().time();
    const MaterialFields<dim> material =
      material_fields(problem.solid(), problem.ghosted_displacement());
    if (parameters.output.is_written(step) || steps().finished())
      {
        field_output.write(step,
                           time,
                           problem.layout().mapping,
                           problem.layout().dof_handler,
                           problem.ghosted_displacement(),
                           material);
        if (!parameters.contact_pairs.empty())
          contact_output.write(step, time, faces);
      }
    point_values.write(step,
                       time,
                       problem.layout().dof_handler,
                       problem.ghosted_displacement(),
                       material);
    if (parameters.output.checkpoint_interval > 0 &&
        step % parameters.output.checkpoint_interval == 0)
      write_checkpoint();
  }



  template <int dim>
  void
  Simulation<dim>::write_checkpoint()
  {
    save_checkpoint(parameters.output.directory,
                    problem,
                    accepted,
                    {step_control.state(), work},
                    parameters.physics);
  }



  template <int dim>
  void
  Simulation<dim>::resume(const std::string &restart_from)
  {
    const std::string &directory =
      restart_from == "latest" ? parameters.output.directory : restart_from;
    ParameterValues         old_physics;
    const CheckpointScalars scalars =
      load_checkpoint(directory, problem, accepted, old_physics);
    work = scalars.work;
    step_control.resume(scalars.control);
    const double time = steps().time();
    // pairs the points and sets the scales that the first thresholds need
    problem.begin_step(time, accepted.x);
    problem.begin_iteration(accepted.x);
    log.note("continues from " + directory);
    if (!old_physics.empty())
      for (const auto &text : changed_values(old_physics, parameters.physics))
        warn("the state was computed with another parameter: " + text + ".");
    if (!checkpoint_is_in(directory, parameters.output.directory, communicator))
      return; // the tables there are of another run
    field_output.resume(time);
    contact_output.resume(time);
    point_values.resume(time);
    statistics.resume(time);
    force_tables.resume(time);
  }



  template <int dim>
  void
  Simulation<dim>::write_statistics()
  {
    const SolveCounts          &counts    = problem.counts;
    const Verification         &found     = step_solver.verification();
    const auto                 &violation = found.violation;
    const CycleTreatmentCounts &cycle_treatment =
      step_solver.cycle_treatment.counts;
    statistics.add("step", steps().step_number());
    statistics.add("time", steps().time());
    statistics.add("algorithm", name_of(solved.algorithm));
    statistics.add("geometry_loops", counts.geometry_loops);
    statistics.add("threshold_loops", counts.threshold_loops);
    statistics.add("status_loops", counts.status_loops);
    statistics.add("newton_iterations", counts.newton_iterations);
    statistics.add("pairings", counts.pairings);
    statistics.add("linear_iterations", counts.linear_iterations);
    statistics.add("multigrid_setups", counts.multigrid_setups);
    statistics.add("direct_fallbacks", counts.direct_fallbacks);
    statistics.add("cuts", step_control.n_cuts());
    statistics.add("failed_newton_iterations",
                   step_solver.failed_newton_iterations());
    statistics.add("cycles", cycle_treatment.cycles);
    statistics.add("adapted_r", cycle_treatment.adapted_scales);
    statistics.add("held_statuses", cycle_treatment.fixed_statuses);
    statistics.add("sparsity_rebuilds", counts.sparsity_rebuilds);
    statistics.add("assembly_seconds", counts.assembly_seconds);
    statistics.add("contact_seconds", counts.contact_seconds);
    statistics.add("setup_seconds", counts.setup_seconds);
    statistics.add("solve_seconds", counts.solve_seconds);
    statistics.add("max_penetration", violation.penetration);
    statistics.add("max_tension", violation.tension);
    statistics.add("max_disc_excess", violation.friction_cone_excess);
    statistics.add("max_stick_slip", violation.stick_slip);
    statistics.add("max_direction_error", violation.direction);
    statistics.add("normal_law_error", violation.normal_law);
    statistics.add("friction_law_error", violation.friction_law);
    statistics.add("fresh_residual", found.residual.equilibrium);
    work.add_to(statistics);
    statistics.finish_row();
  }



  template <int dim>
  unsigned int
  Simulation<dim>::report_final_results()
  {
    FinalResults results = final_results(parameters, problem, point_values);
    work.add_to(results, parameters.load_stepping.stabilization_factor > 0.);
    std::ostringstream text;
    results.print(text);
    const unsigned int n_failed =
      evaluate_checks(parameters.checks, results.values(), text);
    if (progress.prints_results())
      std::cout << text.str() << std::flush;
    return n_failed;
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace stickslip
