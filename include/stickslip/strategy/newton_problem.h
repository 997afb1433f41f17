#ifndef stickslip_strategy_newton_problem_h
#define stickslip_strategy_newton_problem_h

#include <stickslip/base/cycle_treatment.h>
#include <stickslip/base/no_convergence.h>
#include <stickslip/base/types.h>

#include <string>

namespace stickslip
{
  /// One line of a Newton run, for log and tables.
  struct NewtonIteration
  {
    double equilibrium = 0.; ///< relative residual
    double contact     = 0.; ///< largest contact row
    double prescribed = 0.; ///< largest prescribed displacement not applied yet
    /// Size of the whole residual, all rows in one unit and over nothing that
    /// changes during a solve: what the line search compares.
    double merit = 0.;
    /// False if the merit compares with no other, as that of a state that has
    /// been carried to another mesh.
    bool   compares  = true;
    double increment = 0.; ///< relative increment of displacements, multipliers
    double step_length = 1.;
  };



  /**
   * A nonlinear system R(x) = 0 as NewtonSolver sees it. R and the increment
   * are all that a problem has to have; the rest is there for problems with
   * constants of an iteration, with states that are outside of the model, and
   * with statuses whose sequence may repeat. All functions are collective.
   */
  class NewtonProblem
  {
  public:
    virtual ~NewtonProblem() = default;

    /// Called with the start and with every iterate that is kept, but not with
    /// the trials of a line search: renews what is constant until the next one.
    virtual void
    accept_iterate(const LA::BlockVector & /*x*/)
    {}

    /// Called with every trial state before its residual: takes back what an
    /// increment has done beyond any use, and what comes of its being linear
    /// where the motion is not, without effect on a solution.
    virtual void
    limit(LA::BlockVector & /*x*/) const
    {}

    /// The first four entries; with live quantities recomputed.
    virtual NewtonIteration
    residual(const LA::BlockVector &x) = 0;

    /// Solves the problem linearized at @p x for the @p increment, which is 0
    /// before; a relative linear residual of @p sufficient will do (0: as
    /// exactly as usual).
    virtual void
    solve_increment(const LA::BlockVector &x,
                    const double           sufficient,
                    LA::BlockVector       &increment) = 0;

    /// False (with the reason) if the last residual was outside of what the
    /// model can represent, for example an inverted cell.
    virtual bool
    is_admissible(std::string & /*reason*/) const
    {
      return true;
    }

    /// Where the last residual was outside of the model.
    virtual FailurePlace
    inadmissible_place() const
    {
      return {};
    }

    /// Size up to which the unknowns of block @p b are nothing but roundoff.
    virtual double
    negligible_unknown(const unsigned int /*b*/) const
    {
      return 0.;
    }

    /// Called after the residual of the start and of each iterate.
    virtual void
    report(const unsigned int /*iteration*/, const NewtonIteration & /*state*/)
    {}

    /// Called after each iteration, with the last residual that of the new
    /// iterate: sees whether statuses repeat and, if the residual has not
    /// become smaller for a while (@p stagnates), changes the equations of
    /// those that do.
    virtual CycleTreatment
    treat_cycle(const bool /*stagnates*/)
    {
      return CycleTreatment::none;
    }

    /// Called where the residual has converged: takes back what treat_cycle()
    /// has fixed against the equations of the problem. True if there was
    /// anything.
    virtual bool
    release_fixed_statuses()
    {
      return false;
    }
  };
} // namespace stickslip

#endif
