#ifndef stickslip_strategy_line_search_h
#define stickslip_strategy_line_search_h

#include <stickslip/strategy/newton_problem.h>

namespace stickslip
{
  /**
   * Adds the largest of the fractions 1, 1/2, 1/4, ... of @p increment to @p x
   * at which the model has an answer and, with @p needs_decrease, the residual
   * is smaller than that of the iterate @p before, by a tenth of the fraction
   * (Armijo's condition). If no fraction is good enough after @p max_halvings,
   * that with the smallest residual is taken: at the kinks of a contact problem
   * none need reduce it. While displacements are being prescribed residuals do
   * not compare, and the decrease is not asked for.
   *
   * Returns the new state, the last residual being its own; its increment is
   * left to the caller. Throws NoConvergence (inadmissible) if the model has no
   * answer at any of the fractions. Collective.
   */
  NewtonIteration
  advance(NewtonProblem         &problem,
          const LA::BlockVector &increment,
          const NewtonIteration &before,
          const bool             needs_decrease,
          const unsigned int     max_halvings,
          LA::BlockVector       &x);
} // namespace stickslip

#endif
