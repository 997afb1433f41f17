#include <stickslip/problem/rigid_modes.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  template <int dim>
  NodePlaces
  node_places(const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler,
              const Bodies                     &bodies)
  {
    const IndexSet    &owned   = dof_handler.locally_owned_dofs();
    const unsigned int n_nodes = owned.n_elements() / dim;
    NodePlaces         places;
    places.bodies.resize(n_nodes, numbers::invalid_unsigned_int);
    places.positions.resize(n_nodes);
    places.reaches.resize(n_nodes, 0.);
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        // ghosts, too, are around owned nodes
        if (cell->is_artificial())
          continue;
        const double              diameter = cell->diameter();
        const FiniteElement<dim> &fe       = cell->get_fe();
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            if (!owned.is_element(dofs[i]))
              continue;
            const unsigned int node = owned.index_within_set(dofs[i]) / dim;
            AssertDimension(owned.index_within_set(dofs[i]) % dim,
                            fe.system_to_component_index(i).first);
            places.reaches[node] = std::max(places.reaches[node], diameter);
            if (places.bodies[node] != numbers::invalid_unsigned_int)
              continue; // another component, or in another cell
            places.bodies[node] = bodies.body_of(cell->material_id());
            const Point<dim> position =
              mapping[cell->active_fe_index()].transform_unit_to_real_cell(
                cell, fe.unit_support_point(i));
            for (unsigned int d = 0; d < dim; ++d)
              places.positions[node][d] = position[d];
          }
      }
    return places;
  }



  template <int dim>
  NearNullSpace
  rigid_modes(const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler,
              const Constraints                &constraints,
              const Bodies                     &bodies)
  {
    constexpr unsigned int n_modes = RigidBodyModes<dim>::n_modes;
    const IndexSet        &owned   = dof_handler.locally_owned_dofs();
    const std::size_t      n_owned = owned.n_elements();
    const auto boxes   = body_boxes(dof_handler.get_triangulation(), bodies);
    auto       corners = boxes.front(); // of the model
    for (const auto &box : boxes)
      for (unsigned int d = 0; d < dim; ++d)
        {
          corners.first[d]  = std::min(corners.first[d], box.first[d]);
          corners.second[d] = std::max(corners.second[d], box.second[d]);
        }
    const Point<dim> centre =
      corners.first + 0.5 * (corners.second - corners.first);
    const double radius = 0.5 * corners.first.distance(corners.second);

    NearNullSpace space;
    space.n_vectors = n_modes;
    space.nodes     = node_places(mapping, dof_handler, bodies);
    space.values.assign(space.n_vectors * n_owned, 0.);
    std::size_t row = 0;
    for (const auto dof : owned)
      {
        const std::size_t  index     = row++;
        const unsigned int component = index % dim;
        const Point<3>    &place     = space.nodes.positions[index / dim];
        Point<dim>         position;
        for (unsigned int d = 0; d < dim; ++d)
          position[d] = place[d];
        // of bodies of revolution, too: the others are nearly rigid in parts
        // that are small beside their radius
        for (unsigned int m = 0;
             m < n_modes && !constraints.is_constrained(dof);
             ++m)
          space.values[m * n_owned + index] =
            rigid_mode<dim>(m, (position - centre) / radius)[component];
      }
    return space;
  }

#define INSTANTIATE(dim)                                                 \
  template NodePlaces    node_places(const hp::MappingCollection<dim> &, \
                                     const DoFHandler<dim> &,            \
                                     const Bodies &);                    \
  template NearNullSpace rigid_modes(const hp::MappingCollection<dim> &, \
                                     const DoFHandler<dim> &,            \
                                     const Constraints &,                \
                                     const Bodies &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
