#ifndef stickslip_mesh_cell_distribution_h
#define stickslip_mesh_cell_distribution_h

#include <stickslip/mesh/joined_mesh.h>
#include <stickslip/mesh/periodicity.h>

#include <deal.II/base/utilities.h>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/tria.h>

#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * A mesh that METIS has distributed. Its coarse cells have the order that
   * p4est would give them: cells have the same CellId whoever distributes them
   * (what is decided by ids is the same on one rank and on several).
   */
  template <int dim>
  class PartitionedTriangulation
    : public parallel::fullydistributed::Triangulation<dim>
  {
  public:
    /// The numbers of its coarse cells in the joined mesh.
    PartitionedTriangulation(
      const MPI_Comm                              communicator,
      const std::vector<types::global_dof_index> &joined_numbers)
      : parallel::fullydistributed::Triangulation<dim>(communicator)
      , joined_numbers(joined_numbers)
      , coarse_ids(Utilities::invert_permutation(joined_numbers))
    {}

    const std::vector<types::global_dof_index> joined_numbers; ///< by id
    const std::vector<types::global_dof_index> coarse_ids;     ///< the inverse
  };



  /**
   * How the cells of all bodies come to the ranks. A Newton iteration has two
   * phases that wait for each other, the bodies (assembly, linear solver) and
   * contact, whose work is that of slave faces.
   */
  template <int dim>
  struct CellDistribution
  {
    const JoinedMesh<dim>               &coarse_mesh;
    const std::vector<PeriodicBoundary> &periodic_boundaries;
    const unsigned int                   n_refinements; ///< of all cells
    std::set<types::boundary_id>         costly_boundaries = {};

    /// Changes the mesh once it is distributed.
    using LocalRefinement =
      std::function<void(parallel::distributed::Triangulation<dim> &)>;

    /// Along a space-filling curve, body after body, on which a slave face
    /// counts as @p contact_weight cells. The mesh can be refined further.
    /// Collective.
    std::unique_ptr<parallel::DistributedTriangulationBase<dim>>
    with_p4est(const double           contact_weight,
               const LocalRefinement &refine,
               const MPI_Comm         communicator) const;

    /// PartitionedTriangulation by partition_cells(): both phases are balanced.
    /// One rank refines and partitions the serial mesh and sends each rank its
    /// part, which cannot be refined. Collective.
    std::unique_ptr<parallel::DistributedTriangulationBase<dim>>
    with_metis(const MPI_Comm communicator) const;

  private:
    /// The coarse cells in the order in which p4est has them, as they are if it
    /// knows no such cells.
    std::vector<types::global_dof_index>
    order_of_p4est() const;
  };
} // namespace stickslip

#endif
