#ifndef stickslip_simulation_simulation_h
#define stickslip_simulation_simulation_h

#include <stickslip/contact/cycling/status_history.h>

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/output/contact_output.h>
#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/field_output.h>
#include <stickslip/output/point_values.h>
#include <stickslip/output/progress.h>
#include <stickslip/output/statistics_table.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/accepted_state.h>
#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/contact_warnings.h>
#include <stickslip/simulation/convergence_log.h>
#include <stickslip/simulation/force_tables.h>
#include <stickslip/simulation/load_stepping.h>
#include <stickslip/simulation/step_solver.h>
#include <stickslip/simulation/work_balance.h>

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
    /// Builds meshes, spaces and contact pairs. Throws UserError. Collective.
    Simulation(const CaseParameters &parameters, const MPI_Comm &communicator);

    /**
     * Solves all load steps and writes the results. Returns the number of
     * reference checks that fell short. Throws UserError and, when the step
     * cannot be cut any more, NoConvergence; the last accepted state is then in
     * the output directory. Collective.
     */
    unsigned int
    run(const std::string &restart_from);

  private:
    const CaseParameters         &parameters;
    MPI_Comm                      communicator;
    Mesh<dim>                     mesh;
    ContactProblem<dim>           problem;
    std::unique_ptr<LinearSolver> linear_solver;
    LoadStepping                  load_stepping;

    LA::BlockVector x;        ///< present state
    AcceptedState   accepted; ///< last accepted state
    WorkBalance     work;
    unsigned int    n_cuts = 0;
    ContactWarnings warnings;

    FieldOutput<dim>   field_output;
    ContactOutput<dim> contact_output;
    PointValues<dim>   point_values;
    StatisticsTable    statistics;
    ForceTables        force_tables;
    ConvergenceLog     log;
    StepSolver<dim>    step_solver;
    Progress           progress;

    /// Sets x to a guess of the state at @p time.
    void
    predict(const double time);

    void
    solve_step(const double time);

    void
    accept_step();

    /// In the log and on the screen.
    void
    warn(const std::string &text)
    {
      log.note("warning: " + text);
      progress.warn(text);
    }

    void
    give_up_step(const NoConvergence &failure);

    void
    write_results(const std::vector<ContactFaceResult<dim>> &faces);

    void
    write_statistics();

    void
    write_checkpoint();

    void
    resume(const std::string &restart_from);

    unsigned int
    report_final_results();
  };
} // namespace stickslip

#endif
