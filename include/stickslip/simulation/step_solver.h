#ifndef stickslip_simulation_step_solver_h
#define stickslip_simulation_step_solver_h

#include <stickslip/contact/cycling/cycling_cures.h>

#include <stickslip/linear_solvers/linear_solver.h>

#include <stickslip/problem/contact_problem.h>
#include <stickslip/problem/verification.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/convergence_log.h>

#include <stickslip/strategy/algorithm_ladder.h>

#include <string>

namespace stickslip
{
  /**
   * Solves one load step with whatever it takes: the algorithm of the ladder,
   * cures for cycles, and an independent look at the result. All functions are
   * collective.
   */
  template <int dim>
  class StepSolver
  {
  public:
    /// The arguments must outlive this object.
    StepSolver(const CaseParameters &parameters,
               ContactProblem<dim>  &problem,
               LinearSolver         &linear_solver,
               ConvergenceLog       &log);

    /**
     * Solves the step to @p time from the state @p accepted; @p x is a guess
     * before and the solution after. An algorithm that takes more than
     * @p iteration_limit Newton iterations has failed. problem.counts has what
     * the successful one took. Throws NoConvergence when no algorithm of the
     * ladder succeeds.
     */
    void
    solve(const double           time,
          const LA::BlockVector &accepted,
          const unsigned int     iteration_limit,
          LA::BlockVector       &x);

    /// What solved the last step.
    const std::string &
    algorithm() const
    {
      return ladder.algorithm();
    }

    /// What was found in the last solution.
    const Verification &
    verification() const
    {
      return found;
    }

    /// Newton iterations of attempts that failed, since the last reset.
    unsigned int failed_newton_iterations = 0;

    CyclingCures<dim> cures;

  private:
    const CaseParameters &parameters;
    ContactProblem<dim>  &problem;
    LinearSolver         &linear_solver;
    ConvergenceLog       &log;
    AlgorithmLadder       ladder;
    Verification          found;
    unsigned int          most_iterations = 0; ///< of an algorithm in this step

    /// Solves with one algorithm and examines the result. A second time with
    /// other scales, or with points that learn from their hops, if these may be
    /// the reason why that fails.
    void
    solve_with(const std::string     &algorithm,
               const LA::BlockVector &guess,
               LA::BlockVector       &x);

    void
    attempt(const std::string &algorithm, LA::BlockVector &x);

    void
    solve_increment(const LA::BlockVector &state,
                    const double           sufficient,
                    LA::BlockVector       &increment);
  };
} // namespace stickslip

#endif
