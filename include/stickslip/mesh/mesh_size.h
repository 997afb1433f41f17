#ifndef stickslip_mesh_mesh_size_h
#define stickslip_mesh_mesh_size_h

#include <deal.II/base/mpi.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /**
   * Refuses meshes that do not fit into the memory before they are made. What
   * it takes for the need is a lower bound (the mesh and what the caller adds),
   * so that it refuses nothing that could run.
   */
  class MeshSize
  {
  public:
    /// Asks each node for its free memory: collective.
    MeshSize(const unsigned int dim, const MPI_Comm communicator);

    /// Cells that every rank holds: those of a body before it is distributed.
    /// Throws UserError that begins with "@p path: @p what".
    void
    check_coarse(const double       n_cells,
                 const std::string &path,
                 const std::string &what) const;

    /// The same for uniform refinements of a body; names the largest number of
    /// them that fits.
    void
    check_coarse_refinements(const double       n_cells,
                             const unsigned int n_refinements,
                             const std::string &path) const;

    /// For refinements of the distributed mesh of @p n_cells coarse cells.
    /// @p bytes_per_cell is what the caller needs beside the mesh.
    /// @p on_one_rank: one rank holds the refined mesh for a while.
    void
    check_refinements(const double       n_cells,
                      const unsigned int n_refinements,
                      const double       bytes_per_cell,
                      const bool         on_one_rank,
                      const std::string &path) const;

    /// For @p n_cells of a distributed mesh that is refined locally. Throws
    /// UserError that begins with "@p what makes at least".
    void
    check_locally_refined(const double       n_cells,
                          const double       bytes_per_cell,
                          const std::string &what) const;

    /// Of the mesh alone [byte], rounded down: with the numbers of its
    /// unknowns, a refined cube grows by 460 (2D) and 820 (3D) byte per cell.
    static double
    bytes_of_mesh_cell(const unsigned int dim);

  private:
    const unsigned int dim;

    double free_per_rank = 0.; ///< [byte], the least of all ranks
    double free_in_all   = 0.; ///< [byte], over all nodes
  };
} // namespace stickslip

#endif
