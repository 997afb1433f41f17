#include <stickslip/mesh/curved_simplex_mapping.h>

#include <deal.II/base/exceptions.h>

#include <deal.II/fe/fe_simplex_p.h>

#include <utility>

namespace stickslip
{
  namespace
  {
    /// In the order of FE_SimplexP(2): the vertices, then the edges.
    template <int dim>
    std::vector<Point<dim>>
    nodes_on_manifolds(const typename Triangulation<dim>::cell_iterator &cell)
    {
      std::vector<Point<dim>> nodes;
      for (const unsigned int v : cell->vertex_indices())
        nodes.push_back(cell->vertex(v));
      for (const unsigned int l : cell->line_indices())
        nodes.push_back(cell->line(l)->center(/*respect_manifold=*/true));
      return nodes;
    }
  } // namespace



  template <int dim>
  CurvedSimplexMapping<dim>::CurvedSimplexMapping(
    const Triangulation<dim> &triangulation)
    : MappingFE<dim>(FE_SimplexP<dim>(2))
  {
    std::vector<std::vector<Point<dim>>> all(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      if (!cell->is_artificial() && cell->reference_cell().is_simplex())
        all[cell->active_cell_index()] = nodes_on_manifolds<dim>(cell);
    nodes = std::make_shared<const std::vector<std::vector<Point<dim>>>>(
      std::move(all));
  }



  template <int dim>
  std::unique_ptr<Mapping<dim>>
  CurvedSimplexMapping<dim>::clone() const
  {
    return std::make_unique<CurvedSimplexMapping<dim>>(*this);
  }



  template <int dim>
  std::vector<Point<dim>>
  CurvedSimplexMapping<dim>::compute_mapping_support_points(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    AssertIndexRange(cell->active_cell_index(), nodes->size());
    return (*nodes)[cell->active_cell_index()];
  }

  template class CurvedSimplexMapping<2>;
  template class CurvedSimplexMapping<3>;
} // namespace stickslip
