#ifndef stickslip_simulation_simulation_h
#define stickslip_simulation_simulation_h

#include <stickslip/base/stop_requests.h>

#include <stickslip/contact/cycling/status_history.h>

#include <stickslip/mesh/local_refinement.h>
#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/output/contact_output.h>
#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/field_output.h>
#include <stickslip/output/point_values.h>
#include <stickslip/output/progress.h>
#include <stickslip/output/statistics_table.h>

#include <stickslip/problem/automatic_pairs.h>
#include <stickslip/problem/contact_problem.h>
#include <stickslip/problem/start_description.h>

#include <stickslip/simulation/accepted_state.h>
#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/contact_warnings.h>
#include <stickslip/simulation/convergence_log.h>
#include <stickslip/simulation/discretization.h>
#include <stickslip/simulation/failure_report.h>
#include <stickslip/simulation/force_tables.h>
#include <stickslip/simulation/work_balance.h>

#include <stickslip/strategy/step_control.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * A case from its parameters to its results. Owns everything; run() is the
   * whole story.
   */
  template <int dim>
  class Simulation
  {
  public:
    /// Builds meshes, spaces and contact pairs, and adds the automatic ones to
    /// @p parameters. Throws UserError. Collective.
    Simulation(CaseParameters &parameters, const MPI_Comm &communicator);

    /**
     * Solves all load steps and writes the results. Returns the number of
     * reference checks that fell short. Throws UserError; NoConvergence when
     * the step cannot be cut any more, and RunStopped when somebody has asked
     * for an end: the last accepted state is then in the output directory.
     * Collective.
     */
    unsigned int
    run(const std::string &restart_from);

    /// The cells by level where they differ; what is there between the contact
    /// surfaces where nothing is deformed, and what looks wrong about it.
    std::vector<std::string>
    description_of_start()
    {
      std::vector<std::string> lines  = automatic.reasons;
      const auto               levels = describe_levels(mesh.cells_by_level);
      const auto contact = describe(problem().contact(), problem().start());
      lines.insert(lines.end(), levels.begin(), levels.end());
      lines.insert(lines.end(), contact.begin(), contact.end());
      return lines;
    }

  private:
    const CaseParameters         &parameters;
    MPI_Comm                      communicator;
    Mesh<dim>                     mesh;
    AutomaticPairs                automatic;
    const Amplitudes              amplitudes;
    StepControl                   step_control;

    LA::BlockVector  x;        ///< present state
    AcceptedState    accepted; ///< last accepted state
    Attempt          solved;   ///< the last step
    StepControlState control_of_accepted_state;
    WorkBalance      work;
    ContactWarnings  warnings;

    FieldOutput<dim>   field_output;
    ContactOutput<dim> contact_output;
    PointValues<dim>   point_values;
    StatisticsTable    statistics;
    ForceTables        force_tables;
    /// What names of results may mean, in this order.
    std::vector<const StatisticsTable *> result_tables;
    ConvergenceLog                       log;
    StopRequests                         stop_requests;
    Progress                             progress;
    std::unique_ptr<Discretization<dim>> model; ///< of the present mesh

    ContactProblem<dim> &
    problem() const
    {
      return model->problem;
    }

    /// Makes `model` for the present mesh.
    void
    discretize();

    /// Load time; shorter than step_control.steps().
    const LoadStepping &
    steps() const
    {
      return step_control.steps();
    }

    /// Reads the checkpoint to start from, if any, and opens tables and log.
    void
    begin(const std::string &restart_from);

    /// Throws RunStopped.
    void
    begin_step();

    /// Goes on from the accepted state as in the last step, to
    /// steps().next_time().
    LA::BlockVector
    predict() const;

    /// Returns false, and has cut the step, if no attempt succeeded.
    bool
    solve_step();

    void
    accept_step();

    /// In the log and on the screen: description_of_start().
    void
    describe_start()
    {
      for (const std::string &line : description_of_start())
        {
          log.note(line);
          progress.say(line);
        }
    }

    /// In the log and on the screen.
    void
    warn(const std::string &text)
    {
      log.note("warning: " + text);
      progress.warn(text);
    }

    /// Reports @p failure, restores the accepted state and cuts the step. Throws
    /// if that is not possible.
    void
    cut_step(const NoConvergence &failure);

    /// Ends the run at the last accepted state: always throws.
    [[noreturn]] void
    stop(const NoConvergence &failure, const FailureReport &report);

    /// Ends the run at the last accepted state because of @p request, so that
    /// it can go on as if it had not been interrupted: always throws.
    [[noreturn]] void
    interrupt(const RunStopped &request);

    void
    write_results(const std::vector<ContactFaceResult<dim>> &faces);

    void
    write_statistics();

    void
    write_checkpoint(const StepControlState &control);

    /// Continues at the state of @p checkpoint, a directory that --restart
    /// accepts. Returns the parameters that it was computed with.
    ParameterValues
    load_state(const std::string &checkpoint);

    /// Tables and indices go on after the present time.
    void
    continue_tables();

    /// Prints the results. Returns the number of checks that fall short.
    unsigned int
    report_final_results();
  };
} // namespace stickslip

#endif
