#include <stickslip/base/no_convergence.h>

namespace stickslip
{
  std::string
  to_string(const FailureCause cause)
  {
    switch (cause)
      {
        case FailureCause::cycle:
          return "cycle";
        case FailureCause::stagnation:
          return "stagnation";
        case FailureCause::loop_limit:
          return "loop limit";
        case FailureCause::divergence:
          return "divergence";
        case FailureCause::inadmissible:
          return "inadmissible state";
        case FailureCause::singular:
          return "singular matrix";
        case FailureCause::linear_solver:
          return "linear solver";
        case FailureCause::rejected:
          return "rejected state";
      }
    return "";
  }
} // namespace stickslip
