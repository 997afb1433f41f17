#include <stickslip/contact/surface/hanging_nodes.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/index_set.h>

#include <deal.II/distributed/tria_base.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace stickslip
{
  namespace
  {
    using Combinations =
      std::map<types::global_dof_index, HangingNodes::Combination>;



    /// Of all displacement dofs, as far as this rank sees them.
    template <int dim>
    Combinations
    combinations_of(const DoFHandler<dim> &dof_handler)
    {
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      AffineConstraints<double> lines(relevant);
      DoFTools::make_hanging_node_constraints(dof_handler, lines);
      lines.close();
      Combinations result;
      for (const auto &line : lines.get_lines())
        result.emplace(line.index,
                       HangingNodes::Combination(line.entries.begin(),
                                                 line.entries.end()));
      return result;
    }



    /// Of the vertices, in linear functions; named as in @p dof_handler.
    template <int dim>
    Combinations
    linear_combinations_of(const DoFHandler<dim> &dof_handler)
    {
      const auto &triangulation = dof_handler.get_triangulation();
      const auto  fe = make_element<dim>(reference_cell_of(triangulation), 1);
      DoFHandler<dim> linear(triangulation);
      linear.distribute_dofs(*fe);

      std::map<types::global_dof_index, types::global_dof_index> name;
      for (const auto &cell : linear.active_cell_iterators())
        if (!cell->is_artificial())
          {
            const typename DoFHandler<dim>::active_cell_iterator same(
              &triangulation, cell->level(), cell->index(), &dof_handler);
            for (const unsigned int v : cell->vertex_indices())
              name[cell->vertex_dof_index(v, 0)] = same->vertex_dof_index(v, 0);
          }
      Combinations result;
      for (const auto &[dof, combination] : combinations_of(linear))
        for (const auto &[other, weight] : combination)
          result[name.at(dof)].emplace_back(name.at(other), weight);
      return result;
    }
  } // namespace



  template <int dim>
  HangingNodes
  HangingNodes::find(const DoFHandler<dim>                 &dof_handler,
                     const unsigned int                     multiplier_degree,
                     const std::vector<CollectedFace<dim>> &slave_faces)
  {
    HangingNodes result;
    const auto  &triangulation =
      dynamic_cast<const parallel::TriangulationBase<dim> &>(
        dof_handler.get_triangulation());
    if (dim == 2 || !triangulation.has_hanging_nodes())
      return result;

    const Combinations seen = multiplier_degree == dof_handler.get_fe().degree
                                ? combinations_of(dof_handler)
                                : linear_combinations_of(dof_handler);
    // The owner of a node knows whether it hangs, and tells those who see it.
    const IndexSet &owned = dof_handler.locally_owned_dofs();
    IndexSet        relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    LinearAlgebra::distributed::Vector<double> marks(
      owned, relevant, triangulation.get_communicator());
    for (const auto &[key, combination] : seen)
      if (owned.is_element(key))
        marks(key) = 1.;
    marks.update_ghost_values();
    for (const auto &slave : slave_faces)
      for (unsigned int j = 0; j < slave.face.n_nodes; ++j)
        {
          const auto key = slave.face.dofs[j * dim];
          if (marks(key) == 0.)
            continue;
          result.keys.insert(key);
          const auto found = seen.find(key);
          if (found != seen.end())
            result.combinations.insert(*found);
        }
    return result;
  }



  template <int dim>
  types::global_dof_index
  node_shared_with_parent(const CollectedFace<dim> &face)
  {
    // Triangles and tetrahedra are not refined locally: none of their nodes
    // hangs, and children in the middle have no vertex of the parent.
    if (face.cell->level() > 0 && !face.cell->reference_cell().is_simplex())
      {
        // child number i has vertex i of its parent
        const CellId       id      = face.cell->id();
        const auto         indices = id.get_child_indices();
        const unsigned int child   = indices[indices.size() - 1];
        const Point<dim>   vertex  = face.cell->vertex(child);
        for (unsigned int j = 0; j < face.face.n_nodes; ++j)
          if (face.face.reference_positions[j].distance(vertex) <
              1e-6 * face.face.diameter)
            return face.face.dofs[j * dim];
      }
    return numbers::invalid_dof_index;
  }



  MissingNodes
  missing_nodes(const std::vector<types::global_dof_index> &keys,
                const std::set<types::global_dof_index>    &excluded,
                const HangingNodes                         &hanging,
                const types::global_dof_index               shared)
  {
    unsigned int heir = numbers::invalid_unsigned_int;
    for (unsigned int l = 0; l < keys.size(); ++l)
      if (keys[l] == shared)
        heir = l;
    MissingNodes missing;
    for (const auto key : keys)
      {
        const bool does_hang = hanging.contains(key);
        missing.is_missing.push_back(does_hang || excluded.count(key) > 0);
        missing.heir.push_back(does_hang ? heir
                                         : numbers::invalid_unsigned_int);
      }
    return missing;
  }

#define INSTANTIATE(dim)                                    \
  template HangingNodes HangingNodes::find(                 \
    const DoFHandler<dim> &,                                \
    const unsigned int,                                     \
    const std::vector<CollectedFace<dim>> &);               \
  template types::global_dof_index node_shared_with_parent( \
    const CollectedFace<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
