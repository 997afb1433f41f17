#ifndef stickslip_strategy_fixed_point_acceleration_h
#define stickslip_strategy_fixed_point_acceleration_h

#include <stickslip/base/types.h>

#include <deque>

namespace stickslip
{
  /**
   * Anderson's acceleration of a fixed-point iteration x -> g(x): from the
   * last passes it finds the combination of their results whose residual
   * g(x) - x is smallest (Walker and Ni 2011). A loop that contracts slowly, or
   * not at all, in a few directions, as that over the contact geometry does
   * near a limit point, then settles in a few passes. Residuals are measured
   * in the first block, the displacements; the multipliers follow.
   */
  class FixedPointAcceleration
  {
  public:
    /// Replaces @p x, the result of the pass that began at @p start, by a
    /// better start of the next pass. Collective.
    void
    improve(const LA::BlockVector &start, LA::BlockVector &x);

    /// Forgets all passes.
    void
    clear();

  private:
    /// How two successive passes differ.
    struct Difference
    {
      LA::Vector      residual;
      LA::BlockVector result;
    };

    std::deque<Difference> differences; ///< newest first
    LA::Vector             last_residual;
    LA::BlockVector        last_result;

    void
    remember(const LA::Vector &residual, const LA::BlockVector &result);
  };
} // namespace stickslip

#endif
