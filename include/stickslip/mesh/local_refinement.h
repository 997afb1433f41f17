#ifndef stickslip_mesh_local_refinement_h
#define stickslip_mesh_local_refinement_h

#include <stickslip/mesh/body.h>
#include <stickslip/mesh/mesh_size.h>
#include <stickslip/mesh/refinement_parameters.h>

#include <deal.II/distributed/tria.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Refines the cells that the rules @p requests ask for, level by level, with
   * their buffer layers and with what keeps the levels of cells that share a
   * vertex within one. Before each level @p size is asked whether the cells
   * that all levels make, at least, fit; @p bytes_per_cell is what the caller needs of each
   * beside the mesh.
   *
   * Throws UserError, on all ranks, for a mesh that does not fit and for a rule
   * that refines nothing. Collective.
   */
  template <int dim>
  void
  refine_locally(const std::vector<RefinementRequest>      &requests,
                 const Bodies                              &bodies,
                 const MeshSize                            &size,
                 const double                               bytes_per_cell,
                 parallel::distributed::Triangulation<dim> &triangulation);

  /// The number of active cells of each level, over all ranks. Collective.
  template <int dim>
  std::vector<types::global_cell_index>
  cells_by_level(const Triangulation<dim> &triangulation);

  /// "Mesh: 640 cells (level 2: 128, level 3: 512)"; nothing for no levels.
  std::vector<std::string>
  describe_levels(const std::vector<types::global_cell_index> &cells);
} // namespace stickslip

#endif
