#ifndef stickslip_simulation_step_solver_h
#define stickslip_simulation_step_solver_h

#include <stickslip/base/stop_requests.h>

#include <stickslip/contact/cycling/status_cycle_treatment.h>

#include <stickslip/linear_solvers/linear_solver.h>

#include <stickslip/problem/contact_problem.h>
#include <stickslip/problem/verification.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/convergence_log.h>

#include <stickslip/strategy/step_control.h>

namespace stickslip
{
  /**
   * Solves one load step: makes the attempts that the step control decides on,
   * one after the other, and verifies the result. All functions are collective.
   */
  template <int dim>
  class StepSolver
  {
  public:
    /// The arguments must outlive this object.
    StepSolver(const CaseParameters &parameters,
               ContactProblem<dim>  &problem,
               LinearSolver         &linear_solver,
               ConvergenceLog       &log,
               const StopRequests   &stop_requests);

    /// A step begins: all counts of a step are zero.
    void
    begin_step();

    /// Until there is a solution, solve() begins with a state of another mesh.
    void
    begin_on_other_mesh()
    {
      is_on_other_mesh = true;
    }

    /**
     * Solves the step to @p time from the state @p accepted, where attempts may
     * start from @p predicted, too; the solution is @p x. Returns the attempt
     * that solved it; problem.counts has what that one took. Throws the
     * NoConvergence of the last attempt when @p control knows no further one,
     * and RunStopped before an iteration if the run has to end.
     */
    Attempt
    solve(const double           time,
          const LA::BlockVector &accepted,
          const LA::BlockVector &predicted,
          const StepControl     &control,
          LA::BlockVector       &x);

    /// What was found in the last solution.
    const Verification &
    verification() const
    {
      return found;
    }

    /// Newton iterations of attempts at this step that failed.
    unsigned int
    failed_newton_iterations() const
    {
      return failed_iterations;
    }

    StatusCycleTreatment<dim> cycle_treatment;

  private:
    const CaseParameters &parameters;
    ContactProblem<dim>  &problem;
    LinearSolver         &linear_solver;
    ConvergenceLog       &log;
    const StopRequests   &stop_requests;
    Verification          found;
    unsigned int          failed_iterations = 0; ///< of this step
    bool                  is_on_other_mesh  = false;

    /// Brings the contact points into the state that @p attempt begins with.
    void
    prepare(const Attempt &attempt);

    /// Makes an attempt from the guess @p x. Throws NoConvergence.
    void
    make(const Attempt &attempt, LA::BlockVector &x);

    /// Throws NoConvergence if the converged state @p x is wrong.
    void
    verify(const LA::BlockVector &x);
  };
} // namespace stickslip

#endif
