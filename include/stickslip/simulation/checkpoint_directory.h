#ifndef stickslip_simulation_checkpoint_directory_h
#define stickslip_simulation_checkpoint_directory_h

#include <deal.II/base/mpi.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  // The directories checkpoint-a and checkpoint-b below the output directory
  // hold a checkpoint each: the file "description" and per rank a file
  // "cells.N". A directory without description is no checkpoint. The file
  // checkpoint.latest has the name of the valid one. Unless said otherwise the
  // functions are for rank 0 and not collective.

  std::string
  path_of_description(const std::string &checkpoint);

  std::string
  path_of_cells(const std::string &checkpoint, const unsigned int file);

  /// Empties the one below @p directory that is not the valid one and says
  /// which it is. Returns an empty string, or what went wrong.
  std::string
  prepare_next_checkpoint(const std::string &directory,
                          std::string       &checkpoint);

  /// To be called when the files of all ranks are complete: removes those that
  /// a run on more ranks has left, writes the description and makes the
  /// checkpoint the valid one. Returns an empty string, or what went wrong.
  std::string
  declare_complete(const std::string &checkpoint,
                   const std::string &description,
                   const unsigned int n_files);

  /// Makes the checkpoints of an earlier run in @p directory the past:
  /// "--restart latest" no longer means them, their directories still do.
  void
  retire_checkpoints(const std::string &directory);

  /// Path of the checkpoint that --restart @p directory means: the valid one
  /// below, or @p directory itself. Sets @p error if there is none.
  std::string
  find_checkpoint(const std::string &directory, std::string &error);

  /// Path of the other one of the two; "" if @p checkpoint is neither.
  std::string
  checkpoint_beside(const std::string &checkpoint);

  /// Makes @p checkpoint the valid one if it is one of those below
  /// @p output_directory, whatever was: the next one to be written must not
  /// replace it. Returns an empty string, or what went wrong.
  std::string
  make_latest_checkpoint(const std::string &checkpoint,
                         const std::string &output_directory);

  /// True if @p directory, as find_checkpoint() takes it, is
  /// @p output_directory or one of the checkpoints in it. Collective.
  bool
  checkpoint_is_in(const std::string &directory,
                   const std::string &output_directory,
                   const MPI_Comm    &communicator);
} // namespace stickslip

#endif
