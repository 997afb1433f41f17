#ifndef stickslip_strategy_line_search_h
#define stickslip_strategy_line_search_h

#include <stickslip/strategy/convergence_criterion.h>
#include <stickslip/strategy/newton_problem.h>

#include <deque>
#include <optional>

namespace stickslip
{
  /**
   * What the merit of a trial state is compared with: the largest merit of the
   * last iterates (Grippo, Lampariello and Lucidi, "A nonmonotone line search
   * technique for Newton's method", SIAM J. Numer. Anal. 23, 1986). At the
   * kinks of a contact problem the increment need not be a direction of
   * descent, so that the residual has to be allowed to grow for some
   * iterations; but not without limit, as with full steps.
   */
  class MeritReference
  {
  public:
    /// Forgets what was compared before: the equations are others, in the same
    /// solve.
    void
    restart();

    /// An iterate from which a search begins. One that lacks much of the
    /// prescribed displacements has a residual that compares with no other, nor
    /// does one that says so.
    void
    add(const NewtonIteration &state);

    /// Infinity if nothing compares.
    double
    value() const;

  private:
    std::deque<double>    last_merits;
    std::optional<double> prescribed_at_start; ///< of the first iterate
  };



  /// The state at @p x, which was reached by a fraction @p length of an
  /// increment and is limited (NewtonProblem::limit()). Collective.
  NewtonIteration
  state_at(NewtonProblem &problem, const double length, LA::BlockVector &x);

  /// True if the model has numbers for the state.
  bool
  is_finite(const NewtonIteration &state);



  /// Where a search along an increment has ended.
  struct LineSearchResult
  {
    NewtonIteration state;
    bool            is_good; ///< the merit is smaller by Armijo's condition
    bool            full_step_is_admissible; ///< the model has an answer to it
  };



  /**
   * Adds the largest of the fractions 1, 1/2, 1/4, ... of @p increment to @p x
   * at which the model has an answer and the merit is smaller than
   * @p reference, by a tenth of the fraction (Armijo's condition), or so near
   * to the tolerances of @p criterion that roundoff may decide. If no fraction is good
   * enough after @p max_halvings, that with the smallest merit is taken: at the
   * kinks of a contact problem none need reduce it.
   *
   * Returns the new state, the last residual being its own; its increment is
   * left to the caller. Throws NoConvergence (inadmissible) if the model has no
   * answer at any of the fractions. Collective.
   */
  LineSearchResult
  advance(NewtonProblem              &problem,
          const LA::BlockVector      &increment,
          const double                reference,
          const ConvergenceCriterion &criterion,
          const unsigned int          max_halvings,
          LA::BlockVector            &x);
} // namespace stickslip

#endif
