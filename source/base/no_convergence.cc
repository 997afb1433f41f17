#include <stickslip/base/no_convergence.h>

#include <sstream>

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
        case FailureCause::loop_cycle:
          return "loop cycle";
        case FailureCause::budget:
          return "iteration budget";
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



  std::string
  FailurePlace::in_words() const
  {
    if (body.empty())
      return "";
    std::ostringstream text;
    text << "body '" << body << "'";
    for (unsigned int d = 0; d < position.size(); ++d)
      text << (d == 0 ? " at the reference position (" : ", ") << position[d]
           << (d + 1 == position.size() ? ")" : "");
    return text.str();
  }



  NoConvergence::NoConvergence(const std::string  &solver,
                               const std::string  &reason,
                               const FailureCause  cause,
                               const FailurePlace &place)
    : std::runtime_error(solver + ": " + reason +
                         (place.body.empty() ? "" : " in " + place.in_words()))
    , cause(cause)
    , place(place)
    , reason(reason)
  {}



  NoConvergence::NoConvergence(const std::string   &text,
                               const NoConvergence &failure)
    : std::runtime_error(text)
    , cause(failure.cause)
    , place(failure.place)
    , reason(failure.reason)
  {}
} // namespace stickslip
