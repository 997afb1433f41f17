#ifndef stickslip_base_no_convergence_h
#define stickslip_base_no_convergence_h

#include <stdexcept>
#include <string>

namespace stickslip
{
  /**
   * A load step that could not be solved. Thrown by all ranks or by none; the
   * load stepping catches it (and nothing else), restores the last accepted
   * state and cuts the step.
   */
  class NoConvergence : public std::runtime_error
  {
  public:
    /// @p where names the loop that failed, @p why what was seen there.
    NoConvergence(const std::string &where, const std::string &why)
      : std::runtime_error(where + ": " + why)
    {}

    /// The same failure with more to say.
    explicit NoConvergence(const std::string &text)
      : std::runtime_error(text)
    {}
  };
} // namespace stickslip

#endif
