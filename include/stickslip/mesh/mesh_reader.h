#ifndef stickslip_mesh_mesh_reader_h
#define stickslip_mesh_mesh_reader_h

#include <stickslip/mesh/mesh_format.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/tria.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * Reads a mesh of quadrilaterals or hexahedra with the file's boundary and
   * material ids. A relative @p file_name is looked for in @p directory, then in
   * the working directory.
   *
   * Collective over @p communicator: rank 0 reads the file, every rank gets the
   * whole mesh. Throws UserError, on all ranks, blaming parameters below
   * @p path if the file cannot be read or is no mesh of the right kind.
   */
  template <int dim>
  void
  read_mesh(const std::string  &file_name,
            const MeshFormat    format,
            const std::string  &directory,
            const std::string  &path,
            const MPI_Comm      communicator,
            Triangulation<dim> &triangulation);
} // namespace stickslip

#endif
