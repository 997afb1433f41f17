#include <stickslip/problem/dof_layout.h>

#include <stickslip/mesh/conforming_mapping.h>

#include <deal.II/dofs/dof_tools.h>

namespace stickslip
{
  template <int dim>
  DofLayout<dim>::DofLayout(
    const parallel::DistributedTriangulationBase<dim> &triangulation,
    const unsigned int                                 degree,
    const std::vector<PeriodicBoundary>               &periodic)
    : kinds(kinds_of_cells(triangulation))
    , mapping(make_conforming_mapping(triangulation, degree))
    , elements(make_vector_elements<dim>(kinds, degree))
    , dof_handler(triangulation)
  {
    distribute_dofs(elements, dof_handler);
    owned = dof_handler.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    periodic_nodes = PeriodicNodes<dim>(periodic, mapping, dof_handler);
    // an image at the rim of the ghost cells moves with what is out of sight
    for (const auto &[first, image] : periodic_nodes.images())
      relevant.add_range(image.original, image.original + dim);
    relevant.compress();
  }



  IndexSet
  combined_index_set(const IndexSet &displacements, const IndexSet &multipliers)
  {
    IndexSet combined(displacements.size() + multipliers.size());
    combined.add_indices(displacements);
    combined.add_indices(multipliers, displacements.size());
    combined.compress();
    return combined;
  }



  void
  copy_lines(const Constraints &from, Constraints &to)
  {
    for (const auto &line : from.get_lines())
      {
        to.add_line(line.index);
        to.add_entries(line.index, line.entries);
        to.set_inhomogeneity(line.index, line.inhomogeneity);
      }
  }

  template class DofLayout<2>;
  template class DofLayout<3>;
} // namespace stickslip
