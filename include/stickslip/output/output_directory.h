#ifndef stickslip_output_output_directory_h
#define stickslip_output_output_directory_h

#include <deal.II/base/mpi.h>

#include <string>

namespace stickslip
{
  /**
   * Creates the directory @p name with its parents and tests that files can be
   * written into it, so that a run does not fail after its first step.
   * Collective; rank 0 touches the file system. Throws UserError on all ranks,
   * with the reason that the operating system gives.
   */
  void
  prepare_output_directory(const std::string &name,
                           const MPI_Comm     communicator);

  /**
   * Writes @p text under a temporary name and then renames the file: readers
   * see the old or the new content, never half of it. Not collective. Returns
   * an empty string, or what went wrong.
   */
  std::string
  write_file_atomically(const std::string &name, const std::string &text);
} // namespace stickslip

#endif
