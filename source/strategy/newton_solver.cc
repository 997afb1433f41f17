#include <stickslip/strategy/newton_solver.h>

#include <stickslip/strategy/convergence_criterion.h>
#include <stickslip/strategy/forcing_term.h>
#include <stickslip/strategy/globalization.h>
#include <stickslip/strategy/residual_monitors.h>

#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// When repeated statuses are treated. Many are wrong for some iterations
    /// until they find their places, and the residual grows; a cycle never
    /// makes it smaller again.
    constexpr StagnationWindow window_before_treatment{0.9, 6};



    /// What is counted as long as the equations are the same: until statuses
    /// are fixed or released.
    struct Progress
    {
      unsigned int      first_iteration;
      unsigned int      max_iterations;
      StagnationMonitor stagnation{window_before_treatment};
      DescentMonitor    descent{};

      /// A solve that is on its way may take half as many more.
      bool
      ends_at(const unsigned int iteration) const
      {
        const unsigned int n = iteration - first_iteration;
        return n >= max_iterations + max_iterations / 2 ||
               (n >= max_iterations && !descent.is_on_its_way());
      }
    };



    /// The residual of an iterate whose equations have changed; how it was
    /// reached stays.
    NewtonIteration
    with_new_residual(NewtonProblem         &problem,
                      const LA::BlockVector &x,
                      const NewtonIteration &state)
    {
      NewtonIteration result = problem.residual(x);
      result.increment       = state.increment;
      result.step_length     = state.step_length;
      return result;
    }
  } // namespace



  NewtonSolver::NewtonSolver(const NewtonParameters &parameters,
                             NewtonProblem          &problem)
    : parameters(parameters)
    , problem(problem)
  {}



  unsigned int
  NewtonSolver::solve(LA::BlockVector &x) const
  {
    problem.accept_iterate(x);
    NewtonIteration state  = problem.residual(x);
    NewtonIteration before = state;
    problem.report(0, state);

    const ConvergenceCriterion criterion(parameters);
    IncrementNorm              norm(problem, x);
    DivergenceMonitor          divergence(residual_size(state));
    Globalization              globalization(parameters, problem);
    Progress                   progress{0, parameters.max_iterations};
    CycleTreatment             treatment = CycleTreatment::none;
    LA::BlockVector            increment(x);
    for (unsigned int iteration = 0;; ++iteration)
      {
        if (criterion.is_met(iteration, before, state))
          {
            if (!problem.release_fixed_statuses())
              return iteration;
            state = with_new_residual(problem, x, state);
            if (criterion.is_met(iteration, before, state))
              return iteration;
            progress = Progress{iteration, parameters.max_iterations};
            globalization.restart();
          }
        if (progress.ends_at(iteration))
          give_up(state,
                  treatment == CycleTreatment::untreatable
                    ? FailureCause::cycle
                    : FailureCause::stagnation,
                  "no convergence in " + std::to_string(iteration) +
                    " iterations");

        increment = 0.;
        problem.solve_increment(
          x,
          forcing_term(parameters.forcing, criterion, before, state),
          increment);
        before          = state;
        state           = globalization.advance(before, increment, x);
        state.increment = norm.relative_increment(x, increment);
        progress.stagnation.add(residual_size(state));
        progress.descent.add(state.merit);
        divergence.add(residual_size(state));

        treatment = problem.treat_cycle(progress.stagnation.stagnates());
        problem.accept_iterate(x);
        problem.report(iteration + 1, state);
        if (divergence.diverges())
          give_up(state, FailureCause::divergence, "the residual diverges");
        if (treatment == CycleTreatment::treated)
          {
            state    = with_new_residual(problem, x, state);
            progress = Progress{iteration + 1, parameters.max_iterations};
            globalization.restart();
          }
      }
  }



  void
  NewtonSolver::give_up(const NewtonIteration &state,
                        const FailureCause     cause,
                        const std::string     &what) const
  {
    std::ostringstream text;
    text << what << "; last equilibrium residual " << state.equilibrium
         << " (tolerance " << parameters.equilibrium_tolerance
         << "), contact residual " << state.contact << " (tolerance "
         << parameters.contact_tolerance << "), relative increment "
         << state.increment << " (tolerance " << parameters.increment_tolerance
         << ")";
    throw NoConvergence("Newton", text.str(), cause);
  }
} // namespace stickslip
