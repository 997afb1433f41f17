#ifndef stickslip_simulation_failure_explanation_h
#define stickslip_simulation_failure_explanation_h

#include <stickslip/simulation/failed_step.h>

#include <string>

namespace stickslip
{
  /// Why a load step failed: three lines that a person can act on.
  struct FailureExplanation
  {
    std::string name;   ///< a few words, to count failures by
    std::string why;    ///< what was seen
    std::string where;  ///< at which points, or in which body
    std::string advice; ///< what to change in the .prm

    /// The three lines, each with @p indent before it.
    std::string
    text(const std::string &indent) const;
  };



  /**
   * The most telling cause that the traces of a failed step support, tried in
   * this order: an inadmissible cell or material point, a singular matrix
   * (contact lost, threshold missing, sliding, redundant rows), a cycle of
   * statuses or facets, points that change their facets without a cycle, points
   * that lost their master, an outer loop at its limit or repeating itself, a
   * used up iteration budget, a diverging residual,
   * one that stands just above its tolerance, one that falls too slowly.
   * Collective; the same on all ranks.
   */
  template <int dim>
  FailureExplanation
  explain_failure(const FailedStep<dim> &step, const MPI_Comm communicator);
} // namespace stickslip

#endif
