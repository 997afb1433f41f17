#ifndef stickslip_simulation_run_summary_h
#define stickslip_simulation_run_summary_h

#include <iosfwd>
#include <string>

namespace stickslip
{
  /**
   * Prints what `--diagnose` says about a run that is over (or still going on)
   * in the output directory @p directory, from its statistics.csv and
   * convergence.log: how far it came, steps, iterations, cut attempts by cause,
   * the largest violations of the contact law, where the time went, why it
   * stopped and what to change. Not collective. Returns an empty string, or
   * what is missing.
   */
  std::string
  summarize_run(const std::string &directory, std::ostream &out);
} // namespace stickslip

#endif
