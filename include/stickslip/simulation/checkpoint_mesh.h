#ifndef stickslip_simulation_checkpoint_mesh_h
#define stickslip_simulation_checkpoint_mesh_h

#include <deal.II/distributed/tria_base.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /// Whether the checkpoint that --restart @p directory means is one of an
  /// adapted mesh. Collective; throws UserError if there is none.
  bool
  is_of_adapted_mesh(const std::string &directory,
                     const MPI_Comm    &communicator);

  /**
   * If the checkpoint that --restart @p directory means is one of an adapted
   * mesh: refines and coarsens the cells of @p triangulation until they are
   * those of the checkpoint, whose records have their names. Returns whether it
   * is one; if not, nothing has been done.
   *
   * Each pass brings cells one level nearer. In each of them every rank reads
   * the indices of all files (32 bytes per cell), one after the other, and
   * keeps nothing of them.
   *
   * Collective; throws UserError on all ranks if the checkpoint is damaged, or
   * if the cells of this mesh cannot be refined.
   */
  template <int dim>
  bool
  adopt_mesh(const std::string                           &directory,
             parallel::DistributedTriangulationBase<dim> &triangulation);
} // namespace stickslip

#endif
