#ifndef stickslip_base_no_convergence_h
#define stickslip_base_no_convergence_h

#include <stdexcept>
#include <string>

namespace stickslip
{
  /// Why a load step could not be solved: what may help depends on it.
  enum class FailureCause
  {
    cycle,         ///< the contact statuses proved to repeat themselves
    stagnation,    ///< the iteration limit of Newton's method
    loop_limit,    ///< the limit of a fixed-point loop or of all iterations
    divergence,    ///< the residual grew without bound
    inadmissible,  ///< a state outside of what a material or cell can be
    singular,      ///< a matrix that cannot be factorised
    linear_solver, ///< a Krylov method that stalled
    rejected       ///< converged, but to a state that violates the contact law
  };

  /// As it appears in log and statistics.
  std::string
  to_string(const FailureCause cause);

  /**
   * A load step that could not be solved. Thrown by all ranks or by none; the
   * load stepping catches it (and nothing else), restores the last accepted
   * state and cuts the step.
   */
  class NoConvergence : public std::runtime_error
  {
  public:
    /// @p where names the loop that failed, @p why what was seen there.
    NoConvergence(const std::string &where,
                  const std::string &why,
                  const FailureCause cause)
      : std::runtime_error(where + ": " + why)
      , cause(cause)
    {}

    /// The same failure with other words.
    NoConvergence(const std::string &text, const NoConvergence &failure)
      : std::runtime_error(text)
      , cause(failure.cause)
    {}

    const FailureCause cause;
  };
} // namespace stickslip

#endif
