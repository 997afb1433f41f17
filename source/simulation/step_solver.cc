#include <stickslip/simulation/step_solver.h>

#include <stickslip/contact/assembly/friction_multipliers.h>

#include <stickslip/contact/cycling/law_continuation.h>

#include <stickslip/simulation/dual_increment.h>

#include <stickslip/strategy/nested_fixed_point.h>
#include <stickslip/strategy/newton_solver.h>
#include <stickslip/strategy/residual_monitors.h>
#include <stickslip/strategy/solution_strategy.h>

#include <string>

namespace stickslip
{
  namespace
  {
    /// Iterations without progress that are left alone, as long as no cycle is
    /// proven: many steps find their way by themselves.
    constexpr unsigned int patience = 4;



    /// The equations of a step as Newton's method sees them in an attempt.
    template <int dim>
    class StepNewtonProblem : public NewtonProblem
    {
    public:
      StepNewtonProblem(const Attempt             &attempt,
                        const IncrementSolver      increment_solver,
                        ContactProblem<dim>       &problem,
                        LinearSolver              &linear_solver,
                        StatusCycleTreatment<dim> &cycle_treatment,
                        ConvergenceLog            &log,
                        const StopRequests        &stop_requests,
                        const bool                 is_on_other_mesh)
        : attempt(attempt)
        , increment_solver(increment_solver)
        , problem(problem)
        , linear_solver(linear_solver)
        , cycle_treatment(cycle_treatment)
        , log(log)
        , stop_requests(stop_requests)
        , continuation(problem.contact())
        , compares(!is_on_other_mesh)
      {}

      void
      accept_iterate(const LA::BlockVector &x) override
      {
        problem.begin_iteration(x);
      }

      void
      limit(LA::BlockVector &x) const override
      {
        shorten_friction_multipliers(problem.contact(), x.block(1));
        problem.make_rigid(x.block(0));
      }

      NewtonIteration
      residual(const LA::BlockVector &x) override
      {
        const ResidualNorms norms = problem.residual(x);
        NewtonIteration     state;
        state.equilibrium = norms.equilibrium;
        state.contact     = norms.contact;
        state.prescribed  = norms.prescribed;
        state.merit       = norms.merit;
        state.compares    = compares;
        continuation.observe(norms.merit);
        return state;
      }

      void
      solve_increment(const LA::BlockVector &x,
                      const double           sufficient,
                      LA::BlockVector       &increment) override
      {
        stop_requests.check();
        if (problem.counts.newton_iterations >= attempt.budget)
          throw NoConvergence(name_of(attempt.algorithm),
                              "no end in sight after " +
                                std::to_string(attempt.budget) +
                                " Newton iterations, the budget of an attempt",
                              FailureCause::budget);
        ++problem.counts.newton_iterations;
        compares = true;
        if (increment_solver == IncrementSolver::projected_conjugate_gradient)
          solve_dual_increment(problem, x, increment);
        else
          solve_linear_system(x, sufficient, increment);
      }

      bool
      is_admissible(std::string &reason) const override
      {
        if (problem.state_is_admissible())
          return true;
        reason = problem.inadmissible_state().reason;
        return false;
      }

      FailurePlace
      inadmissible_place() const override
      {
        return problem.inadmissible_state().place;
      }

      double
      negligible_unknown(const unsigned int b) const override
      {
        return problem.negligible_unknown(b);
      }

      void
      report(const unsigned int     iteration,
             const NewtonIteration &state) override
      {
        if (iteration == 0)
          {
            n_stagnating      = 0;
            has_treated_cycle = false;
            descent           = DescentMonitor();
          }
        log.newton_iteration(iteration, state);
      }

      CycleTreatment
      treat_cycle(const bool stagnates) override
      {
        descent.add(continuation.observed_merit());
        if (continuation.acts())
          return continuation.advance() ? law_has_changed()
                                        : CycleTreatment::none;
        n_stagnating = stagnates ? n_stagnating + 1 : 0;
        if ((n_stagnating >= patience || (stagnates && has_treated_cycle)) &&
            !descent.descends() && !descent.has_been_far_down() &&
            cycle_treatment.may_round_corners() &&
            increment_solver == IncrementSolver::linear_system &&
            continuation.begin())
          {
            cycle_treatment.release();
            return law_has_changed();
          }
        const CycleTreatment treatment = cycle_treatment.observe(stagnates);
        if (cycle_treatment.last_report())
          log.cycle_treatment(*cycle_treatment.last_report());
        has_treated_cycle |= treatment == CycleTreatment::treated;
        return treatment;
      }

      bool
      release_fixed_statuses() override
      {
        if (!continuation.acts())
          return cycle_treatment.release();
        continuation.sharpen();
        law_has_changed();
        return true;
      }

    private:
      const Attempt              attempt;
      const IncrementSolver      increment_solver;
      ContactProblem<dim>       &problem;
      LinearSolver              &linear_solver;
      StatusCycleTreatment<dim> &cycle_treatment;
      ConvergenceLog            &log;
      const StopRequests        &stop_requests;
      LawContinuation<dim>       continuation;
      unsigned int               n_stagnating      = 0; ///< iterations in a row
      bool                       has_treated_cycle = false; ///< in this solve
      bool                       compares; ///< NewtonIteration::compares
      DescentMonitor             descent;

      CycleTreatment
      law_has_changed()
      {
        log.rounding(problem.contact().rounding);
        return CycleTreatment::treated;
      }

      void
      solve_linear_system(const LA::BlockVector &x,
                          const double           sufficient,
                          LA::BlockVector       &increment)
      {
        problem.assemble(x);
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
        const ContactAssembler<dim> &contact = problem.contact();
        contact.linearized_friction().convert_increment(
          contact.multipliers().owned_nodes(), x.block(1), increment.block(1));
      }
    };
  } // namespace



  template <int dim>
  StepSolver<dim>::StepSolver(const CaseParameters &parameters,
                              ContactProblem<dim>  &problem,
                              LinearSolver         &linear_solver,
                              ConvergenceLog       &log,
                              const StopRequests   &stop_requests)
    : cycle_treatment(parameters.cycling, problem.contact())
    , parameters(parameters)
    , problem(problem)
    , linear_solver(linear_solver)
    , log(log)
    , stop_requests(stop_requests)
  {}



  template <int dim>
  void
  StepSolver<dim>::begin_step()
  {
    failed_iterations      = 0;
    cycle_treatment.counts = CycleTreatmentCounts();
  }



  template <int dim>
  Attempt
  StepSolver<dim>::solve(const double           time,
                         const LA::BlockVector &accepted,
                         const LA::BlockVector &predicted,
                         const StepControl     &control,
                         LA::BlockVector       &x)
  {
    problem.begin_step(time, accepted);
    problem.configure(accepted, true);
    record_initial_pairings(problem.contact());
    cycle_treatment.begin_step();
    for (Attempt attempt = control.first_attempt();;)
      try
        {
          x = attempt.guess == Attempt::Guess::predicted ? predicted : accepted;
          if (attempt.guess == Attempt::Guess::predicted)
            problem.place_rigid_bodies(x.block(0));
          prepare(attempt);
          make(attempt, x);
          verify(x);
          is_on_other_mesh = false;
          return attempt;
        }
      catch (const NoConvergence &failure)
        {
          failed_iterations += problem.counts.newton_iterations;
          // the first matrix is the same in all of them
          if (failure.cause == FailureCause::singular &&
              problem.counts.newton_iterations <= 1)
            throw;
          const auto next =
            control.next_attempt(attempt,
                                 failure.cause,
                                 {cycle_treatment.default_scales_differ(),
                                  cycle_treatment.hysteresis_would_help()});
          if (!next)
            throw;
          log.note(name_of(attempt.algorithm) + " failed: " + failure.what() +
                   "\n" + describe_change(attempt, *next));
          problem.restore();
          attempt = *next;
        }
  }



  template <int dim>
  void
  StepSolver<dim>::prepare(const Attempt &attempt)
  {
    if (attempt.scales == Attempt::Scales::automatic)
      cycle_treatment.use_default_scales();
    if (attempt.pairing == Attempt::Pairing::hysteresis)
      cycle_treatment.activate_hysteresis();
    problem.counts = SolveCounts();
    problem.forget_state();
  }



  template <int dim>
  void
  StepSolver<dim>::make(const Attempt &attempt, LA::BlockVector &x)
  {
    const SolutionStrategy strategy =
      strategy_of(attempt.algorithm, parameters.algorithm);
    StepNewtonProblem<dim> newton_problem(attempt,
                                          strategy.increment_solver,
                                          problem,
                                          linear_solver,
                                          cycle_treatment,
                                          log,
                                          stop_requests,
                                          is_on_other_mesh);
    const NewtonSolver     newton_solver(parameters.algorithm.newton,
                                     newton_problem);
    const NestedFixedPoint fixed_point(
      make_loops(
        strategy, parameters.algorithm, problem.quantities(), problem.counts),
      [&](LA::BlockVector &state) {
        cycle_treatment.begin_solve();
        problem.contact().rounding = LawRounding();
        newton_solver.solve(state);
      },
      [this](const std::string &quantity,
             const unsigned int pass,
             const double       change,
             const unsigned int depth) {
        log.loop_pass(quantity, pass, change, depth);
      });
    fixed_point.solve(x);
  }



  template <int dim>
  void
  StepSolver<dim>::verify(const LA::BlockVector &x)
  {
    found = verify_state(problem, x, parameters.acceptance);
    if (!found.errors.empty())
      throw NoConvergence("The converged state is wrong",
                          found.errors,
                          FailureCause::rejected);
  }

  template class StepSolver<2>;
  template class StepSolver<3>;
} // namespace stickslip
