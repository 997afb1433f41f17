#ifndef stickslip_strategy_newton_solver_h
#define stickslip_strategy_newton_solver_h

#include <stickslip/base/cycle_treatment.h>
#include <stickslip/base/no_convergence.h>
#include <stickslip/base/types.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  struct NewtonParameters
  {
    unsigned int max_iterations        = 30;
    double       equilibrium_tolerance = 1e-8;
    double       contact_tolerance     = 1e-8;
    double       increment_tolerance   = 1e-3;
    std::string  line_search           = "automatic";
    unsigned int max_halvings          = 5;
    std::string  forcing               = "none";

    void
    add_parameters(ParameterHandler &prm);
  };



  /// One line of a Newton run, for log and tables.
  struct NewtonIteration
  {
    double equilibrium = 0.; ///< relative residual
    double contact     = 0.; ///< largest contact row
    double prescribed = 0.; ///< largest prescribed displacement not applied yet
    double increment = 0.; ///< relative increment of displacements, multipliers
    double step_length = 1.;
  };



  /// What Newton's method needs to know of a problem.
  struct NewtonOperators
  {
    /// Renews what is constant during an iteration.
    std::function<void(const LA::BlockVector &x)> begin_iteration;
    /// Fills the first three entries; with live quantities recomputed.
    std::function<NewtonIteration(const LA::BlockVector &x)> residual;
    /// Solves the linearized problem at x for the increment; a relative
    /// residual of @p sufficient will do.
    std::function<void(const LA::BlockVector &x,
                       const double           sufficient,
                       LA::BlockVector       &increment)>
      solve_increment;
    /// False (with the reason) if the last residual was outside of what the
    /// model can represent, for example an inverted cell.
    std::function<bool(std::string &reason)> is_admissible;
    /// Called after each residual, for log and tables.
    std::function<void(const unsigned int iteration, const NewtonIteration &)>
      report;
    /// Called after each iteration: looks for a cycle and, if the residual has
    /// not become smaller for a while (@p stagnates), breaks it.
    std::function<CycleTreatment(const bool stagnates)> treat_cycle;
    /// Called where the residual has converged: takes back what treat_cycle()
    /// holds against the contact law. True if there was anything.
    std::function<bool()> release_holds;
  };



  /**
   * Newton's method with an optional backtracking line search and with room for
   * the treatment of cycles. Knows nothing of mechanics. A state is accepted
   * when the relative equilibrium residual (paper, eq. 25) and the contact rows
   * are below their tolerances, all prescribed displacements are applied, and,
   * if an iteration was needed, its increment was below the increment tolerance
   * (the further terms of eq. 26).
   */
  class NewtonSolver
  {
  public:
    NewtonSolver(const NewtonParameters &parameters, NewtonOperators operators);

    /// Improves @p x until converged; returns the number of iterations, at most
    /// the limit for each set of equations that the treatment of cycles makes.
    /// Throws NoConvergence. Collective.
    unsigned int
    solve(LA::BlockVector &x) const;

  private:
    const NewtonParameters parameters;
    const NewtonOperators  operators;

    /// The largest residual beside its tolerance.
    double
    excess(const NewtonIteration &state) const;

    /**
     * Relative linear residual that the iteration from @p state needs: choice 2
     * of Eisenstat and Walker, "Choosing the forcing terms in an inexact Newton
     * method", SIAM J. Sci. Comput. 17 (1996), with gamma = 0.9 and exponent 2,
     * but no more than a tenth of what the tolerances need. 0 without forcing.
     */
    double
    sufficient_reduction(const NewtonIteration &before,
                         const NewtonIteration &state) const;

    bool
    is_converged(const unsigned int     iteration,
                 const NewtonIteration &state) const;

    /// A converged state remains one without what the treatment of cycles
    /// holds. Renews the residual of @p state.
    bool
    survives_release(const LA::BlockVector &x,
                     const unsigned int     iteration,
                     NewtonIteration       &state) const;

    [[noreturn]] void
    give_up(const NewtonIteration &state,
            const FailureCause     cause,
            const std::string     &what) const;

    /// Adds a fraction of the increment to x that the model and, with
    /// @p backtrack, the residual accept; returns the new state.
    NewtonIteration
    advance(LA::BlockVector       &x,
            const LA::BlockVector &increment,
            const NewtonIteration &before,
            const bool             backtrack) const;
  };
} // namespace stickslip

#endif
