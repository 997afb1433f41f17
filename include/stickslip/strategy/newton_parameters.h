#ifndef stickslip_strategy_newton_parameters_h
#define stickslip_strategy_newton_parameters_h

#include <stickslip/base/choice.h>

namespace stickslip
{
  /// Whether steps are halved while the residual grows.
  enum class LineSearch
  {
    automatic,
    none
  };

  const Choices<LineSearch> &
  all_line_searches();



  /// How exactly the linear system of an iteration is solved.
  enum class Forcing
  {
    none,            ///< to the tolerance of the linear solver
    careful,         ///< to what the iteration can make use of, four digits
    eisenstat_walker ///< likewise, two digits
  };

  const Choices<Forcing> &
  all_forcings();



  /// The section "Algorithm/Newton".
  struct NewtonParameters
  {
    unsigned int max_iterations        = 30;
    double       equilibrium_tolerance = 1e-8;
    double       contact_tolerance     = 1e-8;
    double       increment_tolerance   = 1e-3;
    LineSearch   line_search           = LineSearch::automatic;
    unsigned int max_halvings          = 5;
    Forcing      forcing               = Forcing::careful;

    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace stickslip

#endif
