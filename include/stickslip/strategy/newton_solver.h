#ifndef stickslip_strategy_newton_solver_h
#define stickslip_strategy_newton_solver_h

#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/newton_parameters.h>
#include <stickslip/strategy/newton_problem.h>

#include <string>

namespace stickslip
{
  /**
   * Newton's method with a line search and with room for the treatment of
   * cycles. It knows no mechanics. Each decision has a place of its own:
   * ConvergenceCriterion, forcing_term(), advance() and MeritReference (the
   * length of a step), StagnationMonitor (when the treatment of cycles begins),
   * DivergenceMonitor.
   */
  class NewtonSolver
  {
  public:
    /// The @p problem must outlive this object.
    NewtonSolver(const NewtonParameters &parameters, NewtonProblem &problem);

    /**
     * Improves @p x until converged, with nothing fixed against the equations
     * of the problem; returns the number of iterations. At most 'Max
     * iterations' are made with the same equations; they are counted again
     * after each treatment of a cycle and each release of fixed statuses.
     * Throws NoConvergence. Collective.
     */
    unsigned int
    solve(LA::BlockVector &x) const;

  private:
    const NewtonParameters parameters;
    NewtonProblem         &problem;

    [[noreturn]] void
    give_up(const NewtonIteration &state,
            const FailureCause     cause,
            const std::string     &what) const;
  };
} // namespace stickslip

#endif
