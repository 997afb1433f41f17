#include <stickslip/simulation/failure_report.h>

#include <sstream>

namespace stickslip
{
  std::string
  failure_report(const std::string &failure,
                 const std::string &contact,
                 const double       time,
                 const std::string &state)
  {
    std::ostringstream text;
    text
      << failure << "\nThe contact points when it failed:\n"
      << contact << "Last accepted state: t = " << time << ". " << state
      << "\nAll iterations are in convergence.log. What to try:\n"
         "  - GNM cycles between statuses: 'Algorithm/Name = PNM' or FPM, or "
         "a smaller 'Load stepping/Initial step';\n"
         "  - points hop between master facets: 'Normals = smoothed', a finer "
         "master surface;\n"
         "  - many points unpaired: the slave has slid off the master; "
         "exchange slave and master or enlarge the master boundary;\n"
         "  - the residual grows: 'Algorithm/Newton/Line search = "
         "backtracking'.";
    return text.str();
  }
} // namespace stickslip
