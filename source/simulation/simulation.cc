#include <stickslip/simulation/simulation.h>

#include <stickslip/base/duration.h>
#include <stickslip/base/no_convergence.h>
#include <stickslip/base/user_error.h>

#include <stickslip/contact/results/contact_results.h>
#include <stickslip/simulation/checkpoint.h>
#include <stickslip/simulation/checkpoint_mesh.h>
#include <stickslip/simulation/final_results.h>
#include <stickslip/simulation/run_files.h>
#include <stickslip/simulation/step_statistics.h>
#include <stickslip/solid/periodic_conditions.h>
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
    , mesh(
        build_mesh<dim>(parameters.mesh,
                        parameters.bodies,
                        periodic_requests(parameters.boundary_conditions, dim),
                        communicator,
                        parameters.slave_surfaces()))
    , automatic(parameters.add_automatic_pairs(mesh))
    , step_control(parameters.load_stepping,
                   fallback_sequence(parameters.algorithm.name,
                                     !parameters.contact_pairs.empty()),
                   parameters.algorithm.newton.max_iterations)
    , warnings(parameters.contact_pairs, parameters.bodies)
    , output(parameters, mesh.bodies, communicator)
    , adaptation(parameters.adaptation, mesh)
    , log(parameters.output.directory, communicator)
    , stop_requests(seconds_of_duration(parameters.output.stop_after),
                    communicator)
    , progress(parameters.output.verbosity,
               0.,
               parameters.load_stepping.end_time,
               communicator)
    , state(parameters, mesh, log, stop_requests)
    , motion_warnings(parameters, mesh.bodies, problem())
  {
    output.locate(problem());
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
            adapt_after_step();
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
      output.resume(steps().time());
    prepare_run_files(parameters, start, communicator);
    log.open(start.goes_on);
    for (const auto &list :
         {mesh.warnings,
          warnings_about_locking(parameters.materials,
                                 mesh.bodies,
                                 problem().layout().degree()),
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
    state.begin_step(steps().time());
    adaptation.begin_step();
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
        solved = state.step_solver().solve(
          time, state.accepted.x, state.predict(size), step_control, state.x);
      }
    catch (const NoConvergence &failure)
      {
        change_step(failure);
        return false;
      }
    return !goes_to_contact_change() && !repeats_on_other_mesh();
  }



  template <int dim>
  void
  Simulation<dim>::adapt_after_step()
  {
    if (adaptation.wants_other_mesh(steps().step_number()))
      adapt_mesh();
  }



  template <int dim>
  bool
  Simulation<dim>::repeats_on_other_mesh()
  {
    if (!adaptation.wants_repetition(problem(), state.x))
      return false;
    state.repeat_step();
    adapt_mesh();
    state.step_solver().begin_step();
    return true;
  }



  template <int dim>
  void
  Simulation<dim>::adapt_mesh()
  {
    const double              time = steps().time();
    const StopRequests::Delay no_stop_before_equilibrium(stop_requests);
    problem().begin_step(time, state.accepted.x);
    problem().configure(state.accepted.x, true);
    const auto before = resultants_of(contact_results(problem().contact()));
    do
      log.note(adaptation.record_new_mesh(state.adapt_mesh(time, adaptation)));
    while (adaptation.wants_another_level(problem(), state.accepted.x));
    output.locate(problem());
    if (steps().step_number() == 0)
      return;
    try
      {
        const unsigned int iterations =
          state.find_equilibrium(time, step_control);
        const auto now = resultants_of(contact_results(problem().contact()));
        state.work.add_friction(now);
        log.note(adaptation.record_equilibrium(iterations, before, now));
      }
    catch (const NoConvergence &failure)
      {
        log.note(std::string("no equilibrium on the new mesh, the next step "
                             "has to find it: ") +
                 failure.what());
      }
  }



  template <int dim>
  void
  Simulation<dim>::accept_step()
  {
    if (steps().is_leaping())
      warn(steps().describe_leap());
    state.accept_step(steps().next_time() - steps().time());
    step_control.accept_step(solved, problem().counts.newton_iterations);
    adaptation.accept_step(problem(), state.x);

    const auto faces      = contact_results(problem().contact());
    const auto resultants = resultants_of(faces);
    state.work.add_friction(resultants);
    for (const auto &texts : {warnings.of_step(resultants),
                              motion_warnings.of_step(resultants, problem()),
                              adaptation.warnings_of_step()})
      for (const std::string &text : texts)
        warn(text);
    state.forget_motions(motion_warnings.adrift());
    write_statistics();
    const unsigned int step = steps().step_number();
    output.forces.write(step, steps().time(), resultants, problem());
    output.write(steps(), problem(), faces, adaptation.fields());
    if (parameters.output.is_saved(step, steps().finished()))
      write_checkpoint(step_control.state());
    if (step == 1)
      check_quantities(parameters.checks, output.tables, communicator);
    progress.accepted_step(step,
                           steps().time(),
                           name_of(solved.algorithm) + ", " +
                             std::to_string(
                               problem().counts.newton_iterations) +
                             " Newton iterations");
  }



  template <int dim>
  void
  Simulation<dim>::change_step(const NoConvergence &failure)
  {
    if (steps().is_leaping())
      log.note(std::string("step failed: ") + failure.what());
    else
      {
        failed.emplace(FailureOfStep{
          failure,
          report_failure(failure,
                         steps().step_number() + 1,
                         parameters,
                         problem(),
                         state.step_solver().cycle_treatment.history(),
                         log.last_newton_run())});
        log.note(failed->report.text());
      }
    state.restore();
    const double tried = steps().next_time();
    if (steps().can_be_cut())
      step_control.cut_step();
    else if (!step_control.leap())
      stop();
    progress.rejected_step(tried, failure.what(), steps().step_size());
  }



  template <int dim>
  void
  Simulation<dim>::stop()
  {
    const std::string last =
      steps().describe_last_step() + ": " + failed->failure.what();
    step_control.cut_step(); // a run that goes on begins with a smaller step
    std::string advice = "Continue it with --restart latest.";
    try
      {
        write_checkpoint(step_control.state());
      }
    catch (const UserError &error)
      {
        advice = error.what();
      }
    const auto text = failed->report.final_text(last, steps().time(), advice);
    log.note("stopped: " + text);
    throw NoConvergence(text, failed->failure);
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
  Simulation<dim>::write_checkpoint(const StepControlState &control)
  {
    save_checkpoint(parameters.output.directory,
                    problem(),
                    state.accepted,
                    adaptation.estimate(),
                    {control, state.work, adaptation.progress()},
                    parameters.physics);
  }



  template <int dim>
  ParameterValues
  Simulation<dim>::load_state(const std::string &checkpoint)
  {
    if (adopt_mesh(checkpoint, *mesh.triangulation))
      {
        state.discretize();
        output.locate(problem());
      }
    ParameterValues physics;
    Vector<double>  indicators;
    const auto      scalars = load_checkpoint(
      checkpoint, problem(), state.accepted, indicators, physics);
    state.work = scalars.work;
    step_control.resume(scalars.control);
    // pairs the points and sets the scales that the first thresholds need
    problem().begin_step(steps().time(), state.accepted.x);
    problem().begin_iteration(state.accepted.x);
    adaptation.resume(scalars,
                      indicators,
                      have_same(physics, parameters.physics, "Adaptation/"),
                      problem(),
                      state.accepted.x);
    progress.resume(steps().time());
    return physics;
  }



  template <int dim>
  void
  Simulation<dim>::write_statistics()
  {
    add_step_statistics(step_control,
                        solved,
                        problem().counts,
                        state.step_solver(),
                        output.statistics);
    adaptation.add_to(output.statistics);
    state.work.add_to(output.statistics);
    output.statistics.finish_row();
  }



  template <int dim>
  unsigned int
  Simulation<dim>::report_final_results()
  {
    FinalResults results =
      final_results(parameters, problem(), output.points());
    state.work.add_to(results,
                      parameters.load_stepping.stabilization_factor > 0.);
    std::ostringstream text;
    for (const std::string &warning : warnings.at_end())
      {
        log.note("warning: " + warning);
        text << "Warning: " << warning << '\n';
      }
    results.print(text);
    const CheckReport checks = evaluate_checks(parameters.checks,
                                               output.tables,
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
