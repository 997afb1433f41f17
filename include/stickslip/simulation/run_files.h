#ifndef stickslip_simulation_run_files_h
#define stickslip_simulation_run_files_h

#include <stickslip/simulation/case_parameters.h>

#include <string>

namespace stickslip
{
  /// Where a run that begins stands.
  struct RunStart
  {
    /// What --restart was given, "latest" resolved; empty: at the beginning.
    std::string checkpoint;
    /// The checkpoint is one of the output directory, whose tables go on.
    bool         goes_on = false;
    unsigned int step    = 0; ///< the last one before
  };

  /// What --restart @p restart_from means for @p parameters, all but the step.
  /// Collective.
  RunStart
  find_run_start(const CaseParameters &parameters,
                 const std::string    &restart_from,
                 const MPI_Comm       &communicator);

  /**
   * Makes the output directory that of a run which begins at @p start: removes
   * what an earlier run has left and cannot be part of this one, makes the
   * checkpoint that the run starts from the latest one if it is there, and
   * writes parameters.prm, the record of version, ranks and all values. To be
   * called when nothing can be wrong with the input any more. Collective;
   * throws UserError on all ranks.
   */
  void
  prepare_run_files(const CaseParameters &parameters,
                    const RunStart       &start,
                    const MPI_Comm       &communicator);
} // namespace stickslip

#endif
