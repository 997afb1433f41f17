#ifndef stickslip_base_freezable_quantity_h
#define stickslip_base_freezable_quantity_h

#include <stickslip/base/types.h>

#include <cstdint>
#include <string>

namespace stickslip
{
  /**
   * A quantity q(x) that the residual depends on and that is either live
   * (recomputed in every residual) or frozen while an inner solver runs and
   * refreshed by an outer fixed-point loop. evaluate() leaves the frozen value
   * alone; only accept() changes it. All functions are collective.
   */
  class FreezableQuantity
  {
  public:
    virtual ~FreezableQuantity() = default;

    /// As it appears in the .prm and in the log.
    virtual std::string
    name() const = 0;

    /// From now on recomputed in every residual (true) or frozen (false).
    virtual void
    set_live(const bool live) = 0;

    /// Computes q(x).
    virtual void
    evaluate(const LA::BlockVector &x) = 0;

    /// Distance of the last evaluated value from the frozen one (relative; the
    /// paper's Res for this quantity).
    virtual double
    change() const = 0;

    /// The last evaluated value becomes the frozen one.
    virtual void
    accept() = 0;

    /// A number that tells discrete frozen values apart: a loop that meets one
    /// again will meet all that followed again. 0: not discrete.
    virtual std::uint64_t
    fingerprint() const
    {
      return 0;
    }
  };
} // namespace stickslip

#endif
