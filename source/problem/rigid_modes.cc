#include <stickslip/problem/rigid_modes.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
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
    space.bodies.resize(n_owned);
    space.values.assign(space.n_vectors * n_owned, 0.);
    std::vector<types::global_dof_index> dofs;
    std::vector<bool>                    is_done(n_owned, false);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const unsigned int        body = bodies.body_of(cell->material_id());
        const FiniteElement<dim> &fe   = cell->get_fe();
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            if (!owned.is_element(dofs[i]))
              continue;
            const auto index = owned.index_within_set(dofs[i]);
            if (is_done[index]) // in another cell
              continue;
            is_done[index]      = true;
            space.bodies[index] = body;
            if (constraints.is_constrained(dofs[i]))
              continue;
            const Point<dim> position =
              mapping[cell->active_fe_index()].transform_unit_to_real_cell(
                cell, fe.unit_support_point(i));
            const unsigned int component =
              fe.system_to_component_index(i).first;
            double *const value = space.values.data() + index;
            // of bodies of revolution, too: the others are nearly rigid in
            // parts that are small beside their radius
            for (unsigned int m = 0; m < n_modes; ++m)
              value[m * n_owned] =
                rigid_mode<dim>(m, (position - centre) / radius)[component];
          }
      }
    return space;
  }

#define INSTANTIATE(dim)                                                 \
  template NearNullSpace rigid_modes(const hp::MappingCollection<dim> &, \
                                     const DoFHandler<dim> &,            \
                                     const Constraints &,                \
                                     const Bodies &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
