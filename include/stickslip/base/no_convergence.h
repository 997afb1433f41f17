#ifndef stickslip_base_no_convergence_h
#define stickslip_base_no_convergence_h

#include <stdexcept>
#include <string>
#include <vector>

namespace stickslip
{
  /// Why a load step could not be solved: what may help depends on it.
  enum class FailureCause
  {
    cycle,         ///< the contact statuses proved to repeat themselves
    stagnation,    ///< the iteration cap of Newton's method
    loop_limit,    ///< the limit of a fixed-point loop
    loop_cycle,    ///< a fixed-point loop over statuses that repeats itself
    budget,        ///< the iterations that one attempt at a step may take
    divergence,    ///< the residual grew without bound
    inadmissible,  ///< a state outside of what a material or cell can be
    singular,      ///< a matrix that cannot be factorised
    linear_solver, ///< a Krylov method that stalled
    rejected       ///< converged, but to a state that violates the contact law
  };

  /// As it appears in the log.
  std::string
  to_string(const FailureCause cause);



  /// Where in the model or in the algorithm; what does not apply is empty.
  struct FailurePlace
  {
    std::string         body     = {};
    std::vector<double> position = {}; ///< in the reference configuration
    std::string         loop     = {}; ///< the quantity of a fixed-point loop

    /// "body 'x' at the reference position (1, 2)"; "" without body.
    std::string
    in_words() const;
  };



  /// Why and where a state is outside of what the model can represent.
  struct InadmissibleState
  {
    std::string  reason;
    FailurePlace place;
  };



  /**
   * A load step that could not be solved. Thrown by all ranks or by none; the
   * load stepping catches it (and nothing else), restores the last accepted
   * state and cuts the step.
   */
  class NoConvergence : public std::runtime_error
  {
  public:
    /// @p solver names what failed, @p reason says what was seen.
    NoConvergence(const std::string  &solver,
                  const std::string  &reason,
                  const FailureCause  cause,
                  const FailurePlace &place = FailurePlace());

    /// The same failure with another text.
    NoConvergence(const std::string &text, const NoConvergence &failure);

    const FailureCause cause;
    const FailurePlace place;
    const std::string  reason; ///< what was seen, without solver and place
  };
} // namespace stickslip

#endif
