#include <stickslip/strategy/newton_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Residual growth beyond which an iteration counts as diverged.
    constexpr double divergence_factor = 1e12;

    /// A full step that changes the state by less than this (relatively) leaves
    /// a residual of roundoff, whatever the forces it is compared with: those
    /// of a body without load are roundoff themselves.
    constexpr double roundoff_increment = 1e-13;
    /// How far beyond its tolerance such a residual may be.
    constexpr double roundoff_allowance = 100.;

    /// Iterations without a clearly smaller residual after which an automatic
    /// line search begins to act. Full steps often make the residual grow for
    /// some iterations while the statuses find their places; a cycle of
    /// statuses never makes it smaller again.
    constexpr unsigned int patience = 6;

    /// Reduction of the linear residual that every iteration needs, the first
    /// one, which applies prescribed displacements, included.
    constexpr double largest_forcing = 0.01;



    /// Measures increments against the unknowns, or against the largest that
    /// these have been: where contact is lost, what is left of multipliers is
    /// roundoff, which has no value to settle at.
    class IncrementScale
    {
    public:
      explicit IncrementScale(const LA::BlockVector &x)
        : largest(x.n_blocks())
      {
        see(x);
      }

      double
      relative_increment(const LA::BlockVector &x,
                         const LA::BlockVector &increment)
      {
        see(x);
        double result = 0.;
        for (unsigned int b = 0; b < x.n_blocks(); ++b)
          if (largest[b] > 0.)
            result = std::max(result,
                              increment.block(b).linfty_norm() /
                                std::max(x.block(b).linfty_norm(),
                                         roundoff_increment * largest[b]));
        return result;
      }

    private:
      std::vector<double> largest; ///< by block

      void
      see(const LA::BlockVector &x)
      {
        for (unsigned int b = 0; b < x.n_blocks(); ++b)
          if (x.block(b).size() > 0)
            largest[b] = std::max(largest[b], x.block(b).linfty_norm());
      }
    };



    double
    merit(const NewtonIteration &state)
    {
      return std::max(state.equilibrium, state.contact);
    }



    /// Counts iterations that have not made the residual clearly smaller than
    /// it ever was.
    class Stagnation
    {
    public:
      void
      see(const double residual)
      {
        count    = residual < 0.9 * smallest ? 0 : count + 1;
        smallest = std::min(smallest, residual);
      }

      bool
      lasts_for(const unsigned int iterations) const
      {
        return count >= iterations;
      }

    private:
      double       smallest = std::numeric_limits<double>::max();
      unsigned int count    = 0;
    };
  } // namespace



  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Max iterations",
                      max_iterations,
                      "Newton iterations after which a solve has failed.",
                      Patterns::Integer(1));
    prm.add_parameter(
      "Equilibrium tolerance",
      equilibrium_tolerance,
      "Largest ||F_int + F_contact - F_ext|| / max(||F_ext||, ||reactions||) "
      "(eq. 25 of the paper). A hundred times as much will do after a full "
      "step that has changed the state by roundoff only.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Contact tolerance",
      contact_tolerance,
      "Largest violation of a weak contact condition: gap over the size of the "
      "slave face, or error of the friction multiplier.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Increment tolerance",
      increment_tolerance,
      "Largest relative change of displacements and multipliers in the last "
      "iteration (the further terms of eq. 26).",
      Patterns::Double(0.));
    prm.add_parameter("Line search",
                      line_search,
                      "none: full steps (halved only if a cell would invert). "
                      "backtracking: the step is halved while "
                      "the residual grows. automatic: full steps, and "
                      "backtracking once six iterations have not made the "
                      "residual smaller, as in a cycle of contact statuses.",
                      Patterns::Selection("automatic|none|backtracking"));
    prm.add_parameter("Max halvings",
                      max_halvings,
                      "How often a step is halved by the line search, or "
                      "because it inverts a cell.",
                      Patterns::Integer(0, 30));
    prm.add_parameter(
      "Forcing",
      forcing,
      "How exactly an iterative linear solver works. none: always to its "
      "'Relative tolerance'. Eisenstat-Walker: to what the Newton iteration "
      "can "
      "make use of, at least two digits; faster, but the first iterations take "
      "another path, which can end in another step size or, with friction, in "
      "another state, above all of bodies that only contact holds. MUMPS is "
      "exact anyway.",
      Patterns::Selection("none|Eisenstat-Walker"));
  }



  double
  NewtonSolver::excess(const NewtonIteration &state) const
  {
    constexpr double smallest = std::numeric_limits<double>::min();
    return std::max(state.equilibrium /
                      std::max(parameters.equilibrium_tolerance, smallest),
                    state.contact /
                      std::max(parameters.contact_tolerance, smallest));
  }



  double
  NewtonSolver::sufficient_reduction(const NewtonIteration &before,
                                     const NewtonIteration &state) const
  {
    if (parameters.forcing == "none")
      return 0.;
    // residuals do not compare while displacements are not applied
    if (before.prescribed > 0. || state.prescribed > 0.)
      return largest_forcing;
    const double ratio = excess(state) / excess(before);
    return std::min(largest_forcing,
                    std::max(0.9 * ratio * ratio, 0.1 / excess(state)));
  }



  NewtonSolver::NewtonSolver(const NewtonParameters &parameters,
                             NewtonOperators         operators)
    : parameters(parameters)
    , operators(std::move(operators))
  {}



  bool
  NewtonSolver::is_converged(const unsigned int     iteration,
                             const NewtonIteration &state) const
  {
    const bool is_roundoff = iteration > 0 && state.step_length == 1. &&
                             state.increment <= roundoff_increment;
    const double allowance = is_roundoff ? roundoff_allowance : 1.;
    return state.prescribed == 0. &&
           state.equilibrium <= allowance * parameters.equilibrium_tolerance &&
           state.contact <= parameters.contact_tolerance &&
           (iteration == 0 ||
            state.increment <= parameters.increment_tolerance);
  }



  NewtonIteration
  NewtonSolver::advance(LA::BlockVector       &x,
                        const LA::BlockVector &increment,
                        const NewtonIteration &before,
                        const bool             backtrack) const
  {
    const LA::BlockVector start(x);
    NewtonIteration       best;
    double                best_merit = std::numeric_limits<double>::max();
    double                step       = 1.;
    std::string           reason;
    for (unsigned int halvings = 0; halvings <= parameters.max_halvings;
         ++halvings, step *= 0.5)
      {
        x = start;
        x.add(step, increment);
        NewtonIteration state     = operators.residual(x);
        const bool      is_finite = std::isfinite(merit(state));
        if (!is_finite || !operators.is_admissible(reason))
          {
            if (!is_finite && reason.empty())
              reason = "the residual is not a number";
            continue;
          }
        state.step_length = step;
        if (!backtrack || before.prescribed > 0. ||
            merit(state) < (1. - 0.1 * step) * merit(before))
          return state;
        if (merit(state) < best_merit)
          {
            best       = state;
            best_merit = merit(state);
          }
      }
    if (best_merit == std::numeric_limits<double>::max())
      throw NoConvergence("Newton", reason, FailureCause::inadmissible);
    // No step reduces the residual (its kinks make that normal): take the best.
    x = start;
    x.add(best.step_length, increment);
    operators.residual(x);
    return best;
  }



  bool
  NewtonSolver::survives_release(const LA::BlockVector &x,
                                 const unsigned int     iteration,
                                 NewtonIteration       &state) const
  {
    if (!operators.release_holds())
      return true;
    NewtonIteration released = operators.residual(x);
    released.increment       = state.increment;
    released.step_length     = state.step_length;
    state                    = released;
    return is_converged(iteration, state);
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



  unsigned int
  NewtonSolver::solve(LA::BlockVector &x) const
  {
    LA::BlockVector increment(x);
    operators.begin_iteration(x);
    NewtonIteration state  = operators.residual(x);
    NewtonIteration before = state;
    operators.report(0, state);
    const bool     always_backtrack = parameters.line_search == "backtracking";
    double         first            = merit(state);
    IncrementScale scale(x);
    Stagnation     stagnation;
    bool           cycles = false;
    unsigned int   limit  = parameters.max_iterations;
    for (unsigned int iteration = 0;; ++iteration)
      {
        if (is_converged(iteration, state))
          {
            if (survives_release(x, iteration, state))
              return iteration;
            stagnation = Stagnation();
            limit      = iteration + parameters.max_iterations;
          }
        if (iteration >= limit)
          break;
        const bool backtrack =
          always_backtrack || (parameters.line_search == "automatic" &&
                               stagnation.lasts_for(patience));
        increment = 0.;
        operators.solve_increment(x,
                                  sufficient_reduction(before, state),
                                  increment);
        before          = state;
        state           = advance(x, increment, before, backtrack);
        state.increment = scale.relative_increment(x, increment);
        stagnation.see(merit(state));
        const CycleTreatment treatment =
          operators.treat_cycle(stagnation.lasts_for(patience));
        // the scales follow the pressure, so what they scale must be renewed
        operators.begin_iteration(x);
        operators.report(iteration + 1, state);
        first = std::max(first, merit(state) * (iteration == 0));
        if (merit(state) > divergence_factor * std::max(first, 1.))
          give_up(state, FailureCause::divergence, "the residual diverges");
        if (treatment == CycleTreatment::cured)
          {
            const NewtonIteration cured = operators.residual(x);
            state.equilibrium           = cured.equilibrium;
            state.contact               = cured.contact;
            stagnation                  = Stagnation();
            limit = iteration + 1 + parameters.max_iterations;
          }
        cycles = treatment == CycleTreatment::incurable;
      }
    give_up(state,
            cycles ? FailureCause::cycle : FailureCause::stagnation,
            "no convergence in " + std::to_string(limit) + " iterations");
  }
} // namespace stickslip
