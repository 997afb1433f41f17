#include <stickslip/mesh/cell_distribution.h>

#include <stickslip/mesh/cell_partition.h>

#include <deal.II/grid/tria_description.h>

#include <numeric>

namespace stickslip
{
  namespace
  {
    /// How many faces of @p cell are on one of @p boundaries.
    template <typename Cell>
    unsigned int
    n_faces_on(const std::set<types::boundary_id> &boundaries, const Cell &cell)
    {
      unsigned int n_faces = 0;
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && boundaries.count(face->boundary_id()) > 0)
          ++n_faces;
      return n_faces;
    }



    /// [phase][cell]: bodies, and contact if each rank can have a few faces.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    costs_by_phase(const Triangulation<dim>           &mesh,
                   const std::set<types::boundary_id> &costly_boundaries,
                   const unsigned int                  n_ranks)
    {
      std::vector<unsigned int> of_contact;
      unsigned int              n_faces = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          of_contact.push_back(n_faces_on(costly_boundaries, cell));
          n_faces += of_contact.back();
        }
      std::vector<std::vector<unsigned int>> costs(
        1, std::vector<unsigned int>(mesh.n_active_cells(), 1));
      constexpr unsigned int few = 4;
      if (n_faces >= few * n_ranks)
        costs.push_back(of_contact);
      return costs;
    }
  } // namespace



  template <int dim>
  std::unique_ptr<parallel::DistributedTriangulationBase<dim>>
  CellDistribution<dim>::with_p4est(const double           contact_weight,
                                    const LocalRefinement &refine,
                                    const MPI_Comm         communicator) const
  {
    auto triangulation =
      std::make_unique<parallel::distributed::Triangulation<dim>>(communicator);
    coarse_mesh.create(*triangulation);
    add_periodicity<dim>(periodic_boundaries, *triangulation);
    triangulation->refine_global(n_refinements);
    refine(*triangulation);
    if (contact_weight > 0. && !costly_boundaries.empty())
      {
        // The mesh outlives this object, and is distributed again when it is
        // adapted.
        triangulation->signals.weight.connect(
          [boundaries = costly_boundaries, contact_weight](const auto &cell,
                                                           const auto) {
            constexpr double of_a_cell = 1000.;
            return static_cast<unsigned int>(
              of_a_cell * (1. + contact_weight * n_faces_on(boundaries, cell)));
          });
        triangulation->repartition();
      }
    return triangulation;
  }



  template <int dim>
  std::vector<types::global_dof_index>
  CellDistribution<dim>::order_of_p4est() const
  {
    if (coarse_mesh.has_simplices())
      {
        std::vector<types::global_dof_index> order(coarse_mesh.n_cells());
        std::iota(order.begin(), order.end(), 0);
        return order;
      }
    parallel::distributed::Triangulation<dim> mesh(MPI_COMM_SELF);
    coarse_mesh.create(mesh);
    return mesh.get_p4est_tree_to_coarse_cell_permutation();
  }



  template <int dim>
  std::unique_ptr<parallel::DistributedTriangulationBase<dim>>
  CellDistribution<dim>::with_metis(const MPI_Comm communicator) const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const auto         order   = order_of_p4est();
    const auto         description = TriangulationDescription::Utilities::
      create_description_from_triangulation_in_groups<dim, dim>(
        [&](Triangulation<dim> &serial) {
          coarse_mesh.create(serial, order);
          add_periodicity<dim>(periodic_boundaries, serial);
          serial.refine_global(n_refinements);
        },
        [&](Triangulation<dim> &serial, const MPI_Comm &, const unsigned int) {
          partition_cells(n_ranks,
                          costs_by_phase(serial, costly_boundaries, n_ranks),
                          serial);
        },
        communicator,
        n_ranks);

    auto triangulation =
      std::make_unique<PartitionedTriangulation<dim>>(communicator, order);
    // The description has only the coarse vertices: each rank refines its part
    // again, on the manifolds.
    coarse_mesh.set_manifolds(*triangulation);
    triangulation->create_triangulation(description);
    add_periodicity<dim>(periodic_boundaries, *triangulation);
    return triangulation;
  }



  template struct CellDistribution<2>;
  template struct CellDistribution<3>;
} // namespace stickslip
