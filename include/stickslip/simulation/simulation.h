#ifndef stickslip_simulation_simulation_h
#define stickslip_simulation_simulation_h

#include <stickslip/base/stop_requests.h>

#include <stickslip/contact/cycling/status_history.h>

#include <stickslip/mesh/axis_of_revolution.h>
#include <stickslip/mesh/local_refinement.h>
#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/progress.h>

#include <stickslip/problem/automatic_pairs.h>
#include <stickslip/problem/contact_problem.h>
#include <stickslip/problem/rank_shares.h>
#include <stickslip/problem/start_description.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/contact_warnings.h>
#include <stickslip/simulation/convergence_log.h>
#include <stickslip/simulation/failure_report.h>
#include <stickslip/simulation/mesh_adaptation.h>
#include <stickslip/simulation/motion_warnings.h>
#include <stickslip/simulation/run_output.h>
#include <stickslip/simulation/run_state.h>

#include <stickslip/strategy/step_control.h>

#include <optional>
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
    /// surfaces where nothing is deformed, and what looks wrong about it; what
    /// only contact holds. Collective.
    std::vector<std::string>
    description_of_start()
    {
      std::vector<std::string> lines   = describe_axis(mesh.bodies);
      const auto              &reasons = automatic.reasons;
      const auto               levels  = describe_levels(mesh.cells_by_level);
      const auto contact = describe(problem().contact(), problem().start());
      lines.insert(lines.end(), reasons.begin(), reasons.end());
      lines.insert(lines.end(), levels.begin(), levels.end());
      lines.insert(lines.end(), contact.begin(), contact.end());
      const auto free = describe(problem().free_motions());
      lines.insert(lines.end(), free.begin(), free.end());
      return lines;
    }

  private:
    const CaseParameters &parameters;
    MPI_Comm              communicator;
    Mesh<dim>             mesh;
    AutomaticPairs        automatic;
    StepControl           step_control;

    /// Of the last step that is no leap.
    struct FailureOfStep
    {
      NoConvergence failure;
      FailureReport report;
    };

    Attempt                      solved; ///< the last step
    std::optional<FailureOfStep> failed;
    StepControlState             control_of_accepted_state;
    ContactWarnings              warnings;

    RunOutput<dim>      output;
    MeshAdaptation<dim> adaptation;
    ConvergenceLog      log;
    StopRequests        stop_requests;
    Progress            progress;
    RunState<dim>       state;
    MotionWarnings<dim> motion_warnings;

    ContactProblem<dim> &
    problem() const
    {
      return state.problem();
    }

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

    /// Returns false, and has cut the step, if no attempt succeeded.
    bool
    solve_step();

    /// If contact is made or lost in the step that has been solved, and the
    /// step has to end at another time for that, goes back to where it began:
    /// returns true. Collective.
    bool
    goes_to_contact_change()
    {
      if (!parameters.load_stepping.locates_contact_changes ||
          !step_control.locate_contact_change(state.contact_changes()))
        return false;
      log.note("contact is made or lost in this step: once more, to t = " +
               std::to_string(steps().next_time()));
      state.restore();
      return true;
    }

    /// Adapts the mesh to the accepted state if that is due.
    void
    adapt_after_step();

    /// Adapts the mesh to the solution of a step, if that wants it, and goes
    /// back to where the step began: returns true.
    bool
    repeats_on_other_mesh();

    /// Gives the accepted state the mesh that cells with flags want. If there
    /// is no equilibrium on it, the next step has to find one.
    void
    adapt_mesh();

    std::vector<ContactResultants<dim>>
    resultants_of(const std::vector<ContactFaceResult<dim>> &faces) const
    {
      return compute_contact_resultants(faces,
                                        parameters.contact_pairs.size(),
                                        communicator,
                                        mesh.bodies.cross_section);
    }

    void
    accept_step();

    /// In the log and on the screen: description_of_start(). What ranks have is
    /// in the log only.
    void
    describe_start()
    {
      for (const std::string &line : description_of_start())
        {
          log.note(line);
          progress.say(line);
        }
      for (const std::string &line :
           describe_rank_shares(problem().layout().dof_handler,
                                problem().contact()))
        log.note(line);
    }

    /// In the log and on the screen.
    void
    warn(const std::string &text)
    {
      log.note("warning: " + text);
      progress.warn(text);
    }

    /// Reports @p failure, restores the accepted state and chooses another size
    /// of the step. Throws if there is none left.
    void
    change_step(const NoConvergence &failure);

    /// Ends the run at the last accepted state: always throws.
    [[noreturn]] void
    stop();

    /// Ends the run at the last accepted state because of @p request, so that
    /// it can go on as if it had not been interrupted: always throws.
    [[noreturn]] void
    interrupt(const RunStopped &request);

    void
    write_statistics();

    void
    write_checkpoint(const StepControlState &control);

    /// Continues at the state of @p checkpoint, a directory that --restart
    /// accepts. Returns the parameters that it was computed with.
    ParameterValues
    load_state(const std::string &checkpoint);

    /// Prints the results. Returns the number of checks that fall short.
    unsigned int
    report_final_results();
  };
} // namespace stickslip

#endif
