#ifndef stickslip_strategy_globalization_h
#define stickslip_strategy_globalization_h

#include <stickslip/strategy/convergence_criterion.h>
#include <stickslip/strategy/line_search.h>
#include <stickslip/strategy/newton_parameters.h>
#include <stickslip/strategy/newton_problem.h>

#include <optional>

namespace stickslip
{
  /**
   * How far Newton's method goes along its increments: advance() with the
   * reference of the last iterates, and, where no fraction of an increment is
   * good, a look ahead. Along a curved valley (bodies that hardly change their
   * volume and turn) every fraction of the increment makes the residual grow,
   * however short, while the increments after the full step take it back to
   * less than before; so it is where many points that were about to slip are
   * to turn round. So the full step is taken, and up to seven more as long as
   * each reduces the residual; once it may grow, but not beyond that of two
   * steps before. Unless it falls below that of the best fraction, the iterate
   * goes back to this one, and looks ahead no more.
   */
  class Globalization
  {
  public:
    Globalization(const NewtonParameters &parameters, NewtonProblem &problem);

    /// Forgets all that was before: the equations are others.
    void
    restart();

    /// Goes from @p x, whose state is @p before, along @p increment; returns
    /// the new state, the last residual being its own; its increment is left
    /// to the caller. Throws as stickslip::advance() does. Collective.
    NewtonIteration
    advance(const NewtonIteration &before,
            const LA::BlockVector &increment,
            LA::BlockVector       &x);

  private:
    /// The best fraction of the increment that the look ahead has left.
    struct Alternative
    {
      LA::BlockVector x;
      double          merit;
      double          step_length;
      unsigned int    steps_ahead; ///< full steps taken since
      double          last_merit;  ///< of the iterate before the last
      bool            has_grown;   ///< the merit, on the way
    };

    const NewtonParameters    &parameters;
    NewtonProblem             &problem;
    const ConvergenceCriterion criterion;
    MeritReference             reference;
    std::optional<Alternative> alternative;
    bool                       may_look_ahead = true;

    NewtonIteration
    look_ahead(const NewtonIteration &before,
               const LA::BlockVector &increment,
               LA::BlockVector       &x);
  };
} // namespace stickslip

#endif
