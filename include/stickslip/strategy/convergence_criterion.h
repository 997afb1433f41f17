#ifndef stickslip_strategy_convergence_criterion_h
#define stickslip_strategy_convergence_criterion_h

#include <stickslip/strategy/newton_parameters.h>
#include <stickslip/strategy/newton_problem.h>

#include <vector>

namespace stickslip
{
  /**
   * When an iterate is a solution: the relative equilibrium residual (paper,
   * eq. 25) and the contact rows are at most at their tolerances, all
   * prescribed displacements are applied and, if an iteration was needed, its
   * increment is at most at the increment tolerance (the further terms of eq.
   * 26), or the next one would be roundoff: a full step that reduces the
   * residual by some factor is expected to be followed by an increment smaller
   * by that factor. So a linear step takes one iteration. Where a full step has
   * changed the state by roundoff only, the
   * equilibrium residual is roundoff as well and may be a little larger: forces
   * of a body without load are compared with roundoff themselves.
   */
  class ConvergenceCriterion
  {
  public:
    explicit ConvergenceCriterion(const NewtonParameters &parameters);

    /// @p iteration is the number of iterations that have led to @p state,
    /// @p before the iterate that preceded it.
    bool
    is_met(const unsigned int     iteration,
           const NewtonIteration &before,
           const NewtonIteration &state) const;

    /// The residuals are so small that roundoff may keep them from decreasing.
    bool
    is_near_roundoff(const NewtonIteration &state) const
    {
      return excess(state) <= roundoff_allowance;
    }

    /// The largest residual relative to its tolerance.
    double
    excess(const NewtonIteration &state) const;

  private:
    /// How far above its tolerance a residual of roundoff may be, as a factor.
    static constexpr double roundoff_allowance = 100.;

    const double equilibrium_tolerance;
    const double contact_tolerance;
    const double increment_tolerance;
  };



  /**
   * Measures increments block by block against the unknowns, in the maximum
   * norm, or against roundoff: that of the largest that these have been, or
   * NewtonProblem::negligible_unknown(). Where contact is lost, what is left of
   * the multipliers has no value to settle at.
   */
  class IncrementNorm
  {
  public:
    IncrementNorm(const NewtonProblem &problem, const LA::BlockVector &start);

    /// Size of the @p increment that has led to @p x; the largest of all
    /// blocks. Collective.
    double
    relative_increment(const LA::BlockVector &x,
                       const LA::BlockVector &increment);

  private:
    std::vector<double> largest;    ///< by block
    std::vector<double> negligible; ///< by block
  };
} // namespace stickslip

#endif
