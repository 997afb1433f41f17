#ifndef stickslip_output_parallel_files_h
#define stickslip_output_parallel_files_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /*
   * Files that all ranks of a communicator write together. They have a
   * temporary name (NAME.part) until they are complete. Both functions return
   * an empty string, or why the file cannot be written.
   */

  /// One VTU file of the patches of all ranks of @p communicator. Collective.
  template <int dim, int spacedim>
  std::string
  write_vtu_file(const DataOutInterface<dim, spacedim> &data,
                 const std::string                     &name,
                 const MPI_Comm                         communicator);

  /**
   * One HDF5 file of the data of all ranks of @p communicator, which must have
   * some each. Collective. An error in the middle may concern some ranks only,
   * while the others wait for them: with several ranks it is thrown as
   * std::runtime_error, for which main() ends all of them.
   */
  template <int dim, int spacedim>
  std::string
  write_hdf5_file(const DataOutInterface<dim, spacedim> &data,
                  const DataOutBase::DataOutFilter      &filter,
                  const std::string                     &name,
                  const MPI_Comm                         communicator);
} // namespace stickslip

#endif
