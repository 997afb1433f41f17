#ifndef stickslip_output_parallel_files_h
#define stickslip_output_parallel_files_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <functional>
#include <ostream>
#include <string>

namespace stickslip
{
  using namespace dealii;

  /*
   * Files that all ranks of a communicator write together. They have a
   * temporary name (NAME.part) until they are complete. All functions return
   * an empty string, or why the file cannot be written.
   */

  /// One VTU file of the patches of all ranks of @p communicator. Collective.
  template <int dim, int spacedim>
  std::string
  write_vtu_file(const DataOutInterface<dim, spacedim> &data,
                 const std::string                     &name,
                 const MPI_Comm                         communicator);

  /// Parts of what a rank writes into a VTU file, made one after the other.
  struct VtuPieces
  {
    unsigned int n = 0;
    /// Writes the k-th one, an element 'Piece'. If no rank has any, the first
    /// one writes piece 0, an empty one.
    std::function<void(const unsigned int, std::ostream &)> write;
  };

  /// One VTU file of the pieces of all ranks of @p communicator, of which each
  /// keeps one at a time. Collective.
  std::string
  write_vtu_pieces(const VtuPieces             &pieces,
                   const DataOutBase::VtkFlags &flags,
                   const std::string           &name,
                   const MPI_Comm               communicator);

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
