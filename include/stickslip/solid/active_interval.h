#ifndef stickslip_solid_active_interval_h
#define stickslip_solid_active_interval_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  /// The load times at which a condition acts, ends included.
  struct ActiveInterval
  {
    double from  = -std::numeric_limits<double>::max();
    double until = std::numeric_limits<double>::max();

    bool
    is_always() const
    {
      const ActiveInterval always;
      return from == always.from && until == always.until;
    }

    /// Sums of step sizes reach an end up to roundoff.
    bool
    contains(const double time) const
    {
      const auto slack = [time](const double end) {
        return 1e-10 * std::max(std::abs(time), std::abs(end));
      };
      return time >= from - slack(from) && time <= until + slack(until);
    }
  };
} // namespace stickslip

#endif
