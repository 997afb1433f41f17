#include <stickslip/mesh/conforming_mapping.h>

#include <stickslip/mesh/curved_simplex_mapping.h>
#include <stickslip/mesh/mapping_nodes.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/utilities.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q_cache.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace stickslip
{
  namespace
  {
    using Positions = LinearAlgebra::distributed::Vector<double>;



    template <int dim>
    bool
    has_manifolds(const Triangulation<dim> &triangulation)
    {
      for (const types::manifold_id id : triangulation.get_manifold_ids())
        if (id != numbers::flat_manifold_id)
          return true;
      return false;
    }



    /// Isoparametric for cells of one kind, with all nodes on the manifolds.
    template <int dim>
    std::unique_ptr<Mapping<dim>>
    mapping_on_manifolds(const Triangulation<dim> &triangulation,
                         const ReferenceCell      &kind,
                         const unsigned int        degree)
    {
      if (degree == 1 || !has_manifolds(triangulation))
        return make_mapping<dim>(kind, degree);
      if (kind.is_simplex())
        return std::make_unique<CurvedSimplexMapping<dim>>(triangulation);
      // Manifolds are not cheap; they are asked once instead of for each use.
      const MappingNodes<dim> mapping(degree);
      auto cache = std::make_unique<MappingQCache<dim>>(degree);
      cache->initialize(triangulation, [&](const auto &cell) {
        return cell->reference_cell() == kind
                 ? mapping.compute_mapping_support_points(cell)
                 : std::vector<Point<dim>>(Utilities::pow(degree + 1, dim));
      });
      return cache;
    }



    /// Where @p mapping has the nodes of the cells of this rank.
    template <int dim>
    void
    read_positions(const Mapping<dim>    &mapping,
                   const DoFHandler<dim> &dof_handler,
                   Positions             &positions)
    {
      const auto                          &fe = dof_handler.get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (positions.in_local_range(dofs[i]))
                positions(dofs[i]) = mapping.transform_unit_to_real_cell(
                  cell,
                  fe.unit_support_point(
                    i))[fe.system_to_component_index(i).first];
          }
    }
  } // namespace



  template <int dim>
  hp::MappingCollection<dim>
  make_conforming_mapping(
    const parallel::DistributedTriangulationBase<dim> &triangulation,
    const unsigned int                                 degree)
  {
    hp::MappingCollection<dim> mappings;
    for (const ReferenceCell &kind : kinds_of_cells(triangulation))
      mappings.push_back(*mapping_on_manifolds(triangulation, kind, degree));
    if (!triangulation.has_hanging_nodes())
      return mappings;

    const ReferenceCell cell = reference_cell_of(triangulation);
    const FESystem<dim> fe(*make_element<dim>(cell, degree), dim);
    DoFHandler<dim>     dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    AffineConstraints<double> lines(relevant);
    DoFTools::make_hanging_node_constraints(dof_handler, lines);
    lines.close();

    Positions positions(dof_handler.locally_owned_dofs(),
                        relevant,
                        triangulation.get_communicator());
    read_positions(mappings[0], dof_handler, positions);
    positions.update_ghost_values();
    for (const auto &line : lines.get_lines())
      if (positions.in_local_range(line.index))
        {
          // The owner of a hanging node sees what it hangs on, which does not
          // hang itself (levels differ by one around a vertex).
          double position = 0.;
          for (const auto &[other, weight] : line.entries)
            position += weight * positions(other);
          positions(line.index) = position;
        }
    positions.update_ghost_values();

    MappingQCache<dim> cache(degree);
    cache.initialize(mappings[0], dof_handler, positions, false);
    return hp::MappingCollection<dim>(cache);
  }

  template hp::MappingCollection<2>
  make_conforming_mapping(const parallel::DistributedTriangulationBase<2> &,
                          const unsigned int);
  template hp::MappingCollection<3>
  make_conforming_mapping(const parallel::DistributedTriangulationBase<3> &,
                          const unsigned int);
} // namespace stickslip
