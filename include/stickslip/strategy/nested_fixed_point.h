#ifndef stickslip_strategy_nested_fixed_point_h
#define stickslip_strategy_nested_fixed_point_h

#include <stickslip/base/freezable_quantity.h>

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  /// One freezable quantity and what the algorithm does with it.
  struct FixedPointLoop
  {
    FreezableQuantity *quantity       = nullptr;
    bool               is_live        = true; ///< left to the inner solver
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
   * around an inner solver.
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

    /// One pass inside the loop of @p level, after @p n_failures of the inner
    /// solver in a row. Returns whether all inner loops converged.
    bool
    solve_inside(const unsigned int level,
                 LA::BlockVector   &x,
                 std::string       &failure,
                 unsigned int      &n_failures) const;

    /// Returns whether this and all inner loops converged.
    bool
    solve_level(const unsigned int level,
                LA::BlockVector   &x,
                std::string       &failure) const;
  };
} // namespace stickslip

#endif
