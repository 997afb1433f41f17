#ifndef stickslip_strategy_nested_fixed_point_h
#define stickslip_strategy_nested_fixed_point_h

#include <stickslip/base/freezable_quantity.h>
#include <stickslip/base/no_convergence.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  /// One freezable quantity and what the algorithm does with it.
  struct FixedPointLoop
  {
    FreezableQuantity *quantity       = nullptr;
    bool               is_live        = true; ///< left to the inner solver
    bool               is_relative    = true; ///< its change is, no count
    double             tolerance      = 0.;
    unsigned int       max_iterations = 1;
    /// Goes on when the inner solver fails, so many times in a row, except in
    /// the last pass.
    unsigned int  n_failures_outlived = 0;
    bool          is_accelerated      = false;   ///< see FixedPointAcceleration
    unsigned int *n_loops             = nullptr; ///< counts the passes
  };

  /**
   * The skeleton of FPM, PNM, GNM and all combinations between them: a
   * fixed-point loop for every quantity that is not live, outermost first,
   * around an inner solver. Inner loops stop at a tenth of the last change of
   * the loop around them; before an outer loop is taken as converged they have
   * to reach their own tolerances. A failure of the inner solver may be
   * outlived (FixedPointLoop::n_failures_outlived), except
   * FailureCause::budget, which ends the whole attempt.
   */
  class NestedFixedPoint
  {
  public:
    using InnerSolver = std::function<void(LA::BlockVector &)>;
    /// Called after each pass: quantity, pass, change, nesting depth.
    using Report = std::function<void(const std::string &,
                                      const unsigned int,
                                      const double,
                                      const unsigned int)>;

    NestedFixedPoint(std::vector<FixedPointLoop> loops,
                     InnerSolver                 solve_inner,
                     Report                      report);

    /// Solves for @p x. Throws NoConvergence. Collective.
    void
    solve(LA::BlockVector &x) const;

  private:
    const std::vector<FixedPointLoop> loops;
    const InnerSolver                 solve_inner;
    const Report                      report;

    /// Change at which the loops inside @p level may stop if that of @p level
    /// has last been @p change; 0: at their own tolerances.
    double
    accuracy_inside(const unsigned int level, const double change) const;

    /// One pass inside the loop of @p level, after @p n_failures of the inner
    /// solver in a row. Returns the failure of an inner loop or of the inner
    /// solver, none if all converged.
    std::optional<NoConvergence>
    solve_inside(const unsigned int level,
                 const double       accuracy,
                 LA::BlockVector   &x,
                 unsigned int      &n_failures) const;

    /// Solves until changes are at most @p accuracy, or at most the tolerances.
    /// Returns the failure of this or of an inner loop.
    std::optional<NoConvergence>
    solve_level(const unsigned int level,
                const double       accuracy,
                LA::BlockVector   &x) const;
  };
} // namespace stickslip

#endif
