#ifndef stickslip_mesh_mesh_builder_h
#define stickslip_mesh_mesh_builder_h

#include <stickslip/base/parameter_file.h>
#include <stickslip/mesh/body.h>
#include <stickslip/mesh/body_parameters.h>
#include <stickslip/mesh/mesh_parameters.h>

#include <deal.II/distributed/tria_base.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /// The distributed triangulation of all bodies with the meaning of its ids.
  template <int dim>
  struct Mesh
  {
    std::unique_ptr<parallel::DistributedTriangulationBase<dim>> triangulation;
    Bodies                                                       bodies;
    std::vector<std::string> warnings; ///< for the user
    /// Active cells, over all ranks; empty if all have the same level.
    std::vector<types::global_cell_index> cells_by_level;
  };

  /**
   * Makes the bodies in the order of @p body_parameters, joins them without
   * gluing coinciding vertices, distributes the result and refines it globally,
   * then locally (p4est only, and not beside periodic boundaries). p4est gives
   * a parallel::distributed::Triangulation, which can be refined further; METIS
   * a parallel::fullydistributed::Triangulation, which cannot, and is taken for
   * triangles and tetrahedra whatever the parameter `Partitioner` says. The @p
   * costly_surfaces are those of contact (see CellDistribution).
   *
   * Collective over @p communicator. Every rank builds the coarse (joined) mesh;
   * the fine mesh is distributed (with METIS one rank holds it temporarily).
   * Throws UserError, on all ranks, for any input that gives no usable mesh.
   */
  template <int dim>
  Mesh<dim>
  build_mesh(const MeshParameters               &parameters,
             const NamedList<BodyParameters>    &body_parameters,
             const std::vector<PeriodicRequest> &periodic_requests,
             const MPI_Comm                      communicator,
             const std::vector<NamedSurface>    &costly_surfaces = {});
} // namespace stickslip

#endif
