#include <stickslip/simulation/simulation.h>

#include <stickslip/base/duration.h>
#include <stickslip/base/no_convergence.h>
#include <stickslip/base/user_error.h>

#include <stickslip/contact/results/contact_results.h>
#include <stickslip/simulation/checkpoint.h>
#include <stickslip/simulation/final_results.h>
#include <stickslip/simulation/run_files.h>
#include <stickslip/simulation/step_statistics.h>
#include <stickslip/solid/volumetric_locking.h>

#include <iostream>
#include <sstream>

namespace stickslip
{
  template <int dim>
  Simulation<dim>::Simulation(CaseParameters &parameters,
                              const MPI_Comm &communicator)
    : parameters(parameters)
    , communicator(communicator)
    , mesh(build_mesh<dim>(parameters.mesh,
                           parameters.bodies,
                           parameters.periodic_requests(),
                           communicator,
                           parameters.slave_surfaces()))
    , automatic(parameters.add_automatic_pairs(mesh))
    , amplitudes(parameters.make_amplitudes(communicator))
    , step_control(parameters.load_stepping,
                   fallback_sequence(parameters.algorithm.name,
                                     !parameters.contact_pairs.empty()),
                   parameters.algorithm.newton.max_iterations)
    , warnings(parameters.contact_pairs, parameters.bodies)
    , field_output(parameters.output, mesh.bodies, communicator)
    , contact_output(parameters.output, communicator)
    , point_values(parameters.output, mesh.bodies, communicator)
    , statistics(parameters.output.directory + "/statistics", communicator)
    , force_tables(parameters, communicator)
    , result_tables{&point_values.values_of_steps(),
                    &force_tables.resultants(),
                    &force_tables.reactions(),
                    &statistics}
    , log(parameters.output.directory, communicator)
    , stop_requests(seconds_of_duration(parameters.output.stop_after),
                    communicator)
    , progress(parameters.output.verbosity,
               0.,
               parameters.load_stepping.end_time,
               communicator)
  {
    discretize();
    accepted = AcceptedState::zero(problem());
    x        = accepted.x;
  }



  template <int dim>
  void
  Simulation<dim>::discretize()
  {
    model.reset(); // two at a time would need twice the memory
    model = std::make_unique<Discretization<dim>>(
      parameters, amplitudes, mesh, log, stop_requests);
    point_values.locate(problem().layout().mapping,
                        problem().layout().dof_handler);
  }



  template <int dim>
  unsigned int
  Simulation<dim>::run(const std::string &restart_from)
  {
    begin(restart_from);
    try
      {
        while (!steps().finished())
          {
            begin_step();
            while (!solve_step())
              {}
            accept_step();
          }
      }
    catch (const RunStopped &request)
      {
        interrupt(request);
      }
    log.note("done: " + std::to_string(steps().step_number()) + " steps");
    progress.finished(steps().step_number());
    return report_final_results();
  }



  template <int dim>
  void
  Simulation<dim>::begin(const std::string &restart_from)
  {
    RunStart start = find_run_start(parameters, restart_from, communicator);
    ParameterValues old_physics;
    if (!start.checkpoint.empty())
      old_physics = load_state(start.checkpoint);
    start.step = steps().step_number();
    if (start.goes_on)
      continue_tables();
    prepare_run_files(parameters, start, communicator);
    log.open(start.goes_on);
    for (const auto &list : {mesh.warnings,
                             warnings_about_locking(parameters.materials,
                                                    mesh.bodies,
                                                    problem().layout().fe),
                             warnings.of_parameters()})
      for (const std::string &text : list)
        warn(text);
    if (start.checkpoint.empty())
      return describe_start();
    log.note("continues from " + start.checkpoint);
    if (!old_physics.empty())
      for (const auto &text : changed_values(old_physics, parameters.physics))
        warn("the state was computed with another parameter: " + text + ".");
  }



  template <int dim>
  void
  Simulation<dim>::begin_step()
  {
    control_of_accepted_state = step_control.state();
    stop_requests.check();
    step_control.begin_step();
    model->step_solver.begin_step();
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
    problem().solid().stabilization().begin_step(size);
    log.begin_step(steps().step_number() + 1, time, size);
    try
      {
        solved =
          model->step_solver.solve(time, accepted.x, predict(), step_control, x);
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
    problem().accept_step(x);
    accepted.rate = accepted.advance(x, problem(), work);
    accepted.rate *= 1. / (steps().next_time() - steps().time());
    step_control.accept_step(solved, problem().counts.newton_iterations);

    const auto faces = contact_results(problem().contact());
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
                       problem());
    write_results(faces);
    if (steps().step_number() == 1)
      check_quantities(parameters.checks, result_tables, communicator);
    progress.accepted_step(steps().step_number(),
                           steps().time(),
                           name_of(solved.algorithm) + ", " +
                             std::to_string(problem().counts.newton_iterations) +
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
                     problem(),
                     model->step_solver.cycle_treatment.history(),
                     log.last_newton_run());
    log.note(report.text());
    problem().restore();
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
        write_checkpoint(step_control.state());
      }
    catch (const UserError &error)
      {
        state = error.what();
      }
    const auto text = report.final_text(last, steps().time(), state);
    log.note("stopped: " + text);
    throw NoConvergence(text, failure);
  }



  template <int dim>
  void
  Simulation<dim>::interrupt(const RunStopped &request)
  {
    problem().restore();
    write_checkpoint(control_of_accepted_state);
    std::ostringstream text;
    text << request.what() << ". The last accepted state, step "
         << steps().step_number() << " at t = " << steps().time()
         << ", is saved in '" << parameters.output.directory
         << "'. Continue it with --restart latest.";
    log.note("interrupted: " + text.str());
    throw RunStopped(text.str());
  }



  template <int dim>
  void
  Simulation<dim>::write_results(
    const std::vector<ContactFaceResult<dim>> &faces)
  {
    const unsigned int        step = steps().step_number();
    const double              time = steps().time();
    const MaterialFields<dim> material =
      material_fields(problem().solid(), problem().ghosted_displacement());
    if (parameters.output.is_written(step) || steps().finished())
      {
        field_output.write(step,
                           time,
                           problem().layout().mapping,
                           problem().layout().dof_handler,
                           problem().ghosted_displacement(),
                           material);
        if (!parameters.contact_pairs.empty())
          contact_output.write(step, time, faces);
      }
    point_values.write(step,
                       time,
                       problem().layout().dof_handler,
                       problem().ghosted_displacement(),
                       material,
                       faces);
    if (parameters.output.is_saved(step, steps().finished()))
      write_checkpoint(step_control.state());
  }



  template <int dim>
  void
  Simulation<dim>::write_checkpoint(const StepControlState &control)
  {
    save_checkpoint(parameters.output.directory,
                    problem(),
                    accepted,
                    {control, work},
                    parameters.physics);
  }



  template <int dim>
  ParameterValues
  Simulation<dim>::load_state(const std::string &checkpoint)
  {
    ParameterValues physics;
    const auto      scalars =
      load_checkpoint(checkpoint, problem(), accepted, physics);
    work = scalars.work;
    step_control.resume(scalars.control);
    // pairs the points and sets the scales that the first thresholds need
    problem().begin_step(steps().time(), accepted.x);
    problem().begin_iteration(accepted.x);
    progress.resume(steps().time());
    return physics;
  }



  template <int dim>
  void
  Simulation<dim>::continue_tables()
  {
    const double time = steps().time();
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
    add_step_statistics(
      step_control, solved, problem().counts, model->step_solver, statistics);
    work.add_to(statistics);
    statistics.finish_row();
  }



  template <int dim>
  unsigned int
  Simulation<dim>::report_final_results()
  {
    FinalResults results = final_results(parameters, problem(), point_values);
    work.add_to(results, parameters.load_stepping.stabilization_factor > 0.);
    std::ostringstream text;
    for (const std::string &warning : warnings.at_end())
      {
        log.note("warning: " + warning);
        text << "Warning: " << warning << '\n';
      }
    results.print(text);
    const CheckReport checks = evaluate_checks(parameters.checks,
                                               result_tables,
                                               results.values(),
                                               communicator);
    text << checks.text;
    (progress.prints_results() ? std::cout << text.str()
                               : std::cerr << checks.failed)
      << std::flush;
    return checks.n_failed;
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace stickslip
