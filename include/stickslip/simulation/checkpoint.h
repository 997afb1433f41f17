#ifndef stickslip_simulation_checkpoint_h
#define stickslip_simulation_checkpoint_h

#include <stickslip/adaptivity/error_estimate.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/accepted_state.h>
#include <stickslip/simulation/checkpoint_description.h>

#include <string>

namespace stickslip
{
  /**
   * Writes an accepted @p state below @p directory (the output directory), the
   * histories of @p problem, the faces that the contact points are paired
   * with, the @p estimate of the error if there is one, and the parameters
   * @p physics that the state was computed with.
   *
   * The state is cut into records of cells: nodal values, point history,
   * multipliers and contact points of the cell's slave faces. Each rank writes
   * those of its own cells into a file of its own (so values at nodes between
   * cells are there several times), which needs no communication and little
   * memory. The records have names of cells that
   * no partition changes: any number of ranks with either
   * partitioner can read what any other wrote.
   *
   * The directories checkpoint-a and checkpoint-b are used in turn, and the
   * file checkpoint.latest, renamed into place when all ranks are done, names
   * the valid one: there is a whole checkpoint at any time, also if the run
   * dies here. Collective; throws UserError on all ranks if it cannot be
   * written.
   */
  template <int dim>
  void
  save_checkpoint(const std::string       &directory,
                  ContactProblem<dim>     &problem,
                  const AcceptedState     &state,
                  const ErrorEstimate     *estimate,
                  const CheckpointScalars &scalars,
                  const ParameterValues   &physics);

  /// The description of the checkpoint that --restart @p directory means, and
  /// its own directory @p checkpoint, on all ranks. Throws UserError if there is
  /// none, if it is damaged or of another version. Collective.
  CheckpointDescription
  read_description(const std::string &directory,
                   const MPI_Comm    &communicator,
                   std::string       &checkpoint);

  /**
   * Reads the latest complete checkpoint below @p directory, or the one that
   * @p directory itself is, into @p state and the histories of @p problem. It must be the same mesh with the same contact
   * pairs, and no step may have been made yet: the pairings become valid when
   * the problem is configured for the first time. @p physics are the parameters
   * that the state was computed with, @p indicators those of the error, to which
   * the returned energy norm belongs.
   *
   * A rank looks into the files beginning with those where its own number
   * stands and stops when it has all its cells: one file if nothing has
   * changed, a few neighbours for other numbers of ranks if the cells are in
   * space-filling order (p4est). It reads the index of a file (32 bytes per
   * cell), then only its own records. At worst (METIS, other numbers) every
   * rank reads all indices, one after the other: 320 MB of reading for ten
   * million cells, and memory for one of them.
   *
   * Collective; throws UserError on all ranks if there is none or it does not
   * fit or is damaged: every byte of every file is behind a checksum or an
   * expected value, and each file is opened by some rank.
   */
  template <int dim>
  CheckpointScalars
  load_checkpoint(const std::string   &directory,
                  ContactProblem<dim> &problem,
                  AcceptedState       &state,
                  Vector<double>      &indicators,
                  ParameterValues     &physics);
} // namespace stickslip

#endif
