#include <stickslip/simulation/step_solver.h>

#include <stickslip/simulation/dual_increment.h>

#include <stickslip/strategy/nested_fixed_point.h>
#include <stickslip/strategy/newton_solver.h>
#include <stickslip/strategy/solution_strategy.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Newton iterations, over the limit of one solve, that an algorithm of
    /// `automatic` may take in a step before the next one is tried.
    constexpr unsigned int iterations_before_next = 10;



    /// The equations of a step as Newton's method sees them.
    template <int dim>
    class StepNewtonProblem : public NewtonProblem
    {
    public:
      using SolveIncrement = std::function<
        void(const LA::BlockVector &, const double, LA::BlockVector &)>;

      StepNewtonProblem(ContactProblem<dim> &problem,
                        CyclingCures<dim>   &cures,
                        ConvergenceLog      &log,
                        SolveIncrement       solve)
        : problem(problem)
        , cures(cures)
        , log(log)
        , solve(std::move(solve))
      {}

      void
      accept_iterate(const LA::BlockVector &x) override
      {
        problem.begin_iteration(x);
      }

      NewtonIteration
      residual(const LA::BlockVector &x) override
      {
        const ResidualNorms norms = problem.residual(x);
        return {norms.equilibrium, norms.contact, norms.prescribed};
      }

      void
      solve_increment(const LA::BlockVector &x,
                      const double           sufficient,
                      LA::BlockVector       &increment) override
      {
        solve(x, sufficient, increment);
      }

      bool
      is_admissible(std::string &reason) const override
      {
        return problem.state_is_admissible(reason);
      }

      void
      report(const unsigned int     iteration,
             const NewtonIteration &state) override
      {
        log.newton_iteration(iteration, state);
      }

      CycleTreatment
      treat_cycle(const bool stagnates) override
      {
        const CycleTreatment treatment = cures.observe(stagnates);
        if (!cures.description().empty())
          log.note(cures.description());
        return treatment;
      }

      bool
      release_fixed_statuses() override
      {
        return cures.release();
      }

    private:
      ContactProblem<dim> &problem;
      CyclingCures<dim>   &cures;
      ConvergenceLog      &log;
      const SolveIncrement solve;
    };
  } // namespace



  template <int dim>
  StepSolver<dim>::StepSolver(const CaseParameters &parameters,
                              ContactProblem<dim>  &problem,
                              LinearSolver         &linear_solver,
                              ConvergenceLog       &log)
    : cures(parameters.cycling, problem.contact())
    , parameters(parameters)
    , problem(problem)
    , linear_solver(linear_solver)
    , log(log)
    // without contact all algorithms are the same
    , ladder(parameters.algorithm.name == "automatic" &&
                 parameters.contact_pairs.empty()
               ? "GNM"
               : parameters.algorithm.name)
  {}



  template <int dim>
  void
  StepSolver<dim>::solve(const double           time,
                         const LA::BlockVector &accepted,
                         const unsigned int     iteration_limit,
                         LA::BlockVector       &x)
  {
    most_iterations = iteration_limit;
    if (ladder.has_choice())
      most_iterations = std::min(most_iterations,
                                 iterations_before_next *
                                   parameters.algorithm.newton.max_iterations);
    problem.begin_step(time, accepted);
    problem.configure(accepted, true);
    record_initial_pairings(problem.contact());
    ladder.begin_step();
    cures.begin_step();
    LA::BlockVector guess(x);
    while (true)
      try
        {
          solve_with(ladder.algorithm(), guess, x);
          ladder.accept_step();
          return;
        }
      catch (const NoConvergence &failure)
        {
          const std::string failed = ladder.algorithm();
          if (!ladder.climb(failure))
            throw;
          log.note(failed + " failed: " + failure.what() + "\ntrying " +
                   ladder.algorithm());
          problem.restore();
          guess = accepted;
        }
  }



  template <int dim>
  void
  StepSolver<dim>::solve_with(const std::string     &algorithm,
                              const LA::BlockVector &guess,
                              LA::BlockVector       &x)
  {
    try
      {
        x = guess;
        attempt(algorithm, x);
      }
    catch (const NoConvergence &failure)
      {
        const bool other_scales = cures.natural_scales_differ();
        const bool now_learning = cures.learning_would_help();
        cures.use_natural_scales();
        cures.let_points_learn();
        if (!other_scales && !now_learning)
          throw;
        log.note(
          algorithm + " failed: " + failure.what() + "\ntrying again" +
          (other_scales ? "; r is at the stiffness of the contact" : "") +
          (now_learning ? "; points that hop keep their facets" : ""));
        problem.restore();
        x = guess;
        attempt(algorithm, x);
      }
  }



  template <int dim>
  void
  StepSolver<dim>::attempt(const std::string &algorithm, LA::BlockVector &x)
  {
    StepNewtonProblem<dim> newton_problem(
      problem,
      cures,
      log,
      [this](const auto &state, const double sufficient, auto &increment) {
        solve_increment(state, sufficient, increment);
      });
    const NewtonSolver     newton_solver(parameters.algorithm.newton,
                                     newton_problem);
    const NestedFixedPoint fixed_point(
      make_loops(
        algorithm, parameters.algorithm, problem.quantities(), problem.counts),
      [&](LA::BlockVector &state) {
        cures.begin_solve();
        newton_solver.solve(state);
      },
      [this](const std::string &quantity,
             const unsigned int pass,
             const double       change,
             const unsigned int depth) {
        log.loop_pass(quantity, pass, change, depth);
      });
    problem.counts = SolveCounts();
    problem.forget_state();
    try
      {
        fixed_point.solve(x);
        found = verify_state(problem, x, parameters.acceptance);
        if (!found.errors.empty())
          throw NoConvergence("The converged state is wrong",
                              found.errors,
                              FailureCause::rejected);
      }
    catch (const NoConvergence &)
      {
        failed_newton_iterations += problem.counts.newton_iterations;
        throw;
      }
  }



  template <int dim>
  void
  StepSolver<dim>::solve_increment(const LA::BlockVector &state,
                                   const double           sufficient,
                                   LA::BlockVector       &increment)
  {
    if (problem.counts.newton_iterations >= most_iterations)
      throw NoConvergence(ladder.algorithm(),
                          "no end in sight after " +
                            std::to_string(problem.counts.newton_iterations) +
                            " Newton iterations",
                          FailureCause::loop_limit);
    ++problem.counts.newton_iterations;
    if (ladder.algorithm() == "GCP")
      {
        solve_dual_increment(problem, state, increment);
        return;
      }
    problem.assemble(state);
    const std::string note = linear_solver.solve_system(
      problem.matrix(),
      [this]() -> const auto & { return problem.describe_system(); },
      problem.right_hand_side(),
      sufficient,
      increment,
      problem.counts);
    if (!note.empty())
      log.note(note);
    problem.distribute(increment);
  }

  template class StepSolver<2>;
  template class StepSolver<3>;
} // namespace stickslip
