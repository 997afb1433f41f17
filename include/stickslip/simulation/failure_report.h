#ifndef stickslip_simulation_failure_report_h
#define stickslip_simulation_failure_report_h

#include <string>

namespace stickslip
{
  /**
   * What a user reads when a run ends without convergence: the failing loop
   * (@p failure), what the contact points were doing (@p contact), where the
   * last accepted state of time @p time is (@p state), and what to try.
   */
  std::string
  failure_report(const std::string &failure,
                 const std::string &contact,
                 const double       time,
                 const std::string &state);
} // namespace stickslip

#endif
