#include <stickslip/problem/rigid_modes.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <algorithm>
#include <set>

namespace stickslip
{
  template <int dim>
  std::vector<unsigned int>
  colour_bodies(const Bodies                                         &bodies,
                const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs,
                const std::vector<bool>                              &driven)
  {
    std::vector<std::set<unsigned int>> neighbours(bodies.n_bodies());
    for (const auto &pair : pairs)
      {
        const unsigned int slave =
          bodies.index_of(pair->parameters.slave_body,
                          "Contact/" + pair->name + "/Slave body");
        const unsigned int master =
          bodies.index_of(pair->parameters.master_body,
                          "Contact/" + pair->name + "/Master body");
        if (slave != master)
          {
            neighbours[slave].insert(master);
            neighbours[master].insert(slave);
          }
      }
    // greedy: the smallest colour that no neighbour has yet
    std::vector<unsigned int> colours(bodies.n_bodies(),
                                      numbers::invalid_unsigned_int);
    for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
      if (!bodies.bodies[b].is_rigid || (!driven.empty() && driven[b]))
        {
          std::set<unsigned int> taken;
          for (const unsigned int other : neighbours[b])
            taken.insert(colours[other]);
          colours[b] = 0;
          while (taken.count(colours[b]) > 0)
            ++colours[b];
        }
    return colours;
  }



  template <int dim>
  NearNullSpace
  rigid_modes(const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler,
              const Constraints                &constraints,
              const Bodies                     &bodies,
              const std::vector<unsigned int>  &colours)
  {
    constexpr unsigned int n_modes   = RigidBodyModes<dim>::n_modes;
    const IndexSet        &owned     = dof_handler.locally_owned_dofs();
    const std::size_t      n_owned   = owned.n_elements();
    unsigned int           n_colours = 1;
    for (const unsigned int colour : colours)
      if (colour != numbers::invalid_unsigned_int)
        n_colours = std::max(n_colours, colour + 1);
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
    space.n_vectors = n_modes * n_colours;
    space.values.assign(space.n_vectors * n_owned, 0.);
    std::vector<types::global_dof_index> dofs;
    std::vector<bool>                    is_done(n_owned, false);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const unsigned int colour =
          colours[bodies.body_of(cell->material_id())];
        if (colour == numbers::invalid_unsigned_int)
          continue;
        const FiniteElement<dim> &fe = cell->get_fe();
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            if (!owned.is_element(dofs[i]) ||
                constraints.is_constrained(dofs[i]))
              continue;
            const auto index = owned.index_within_set(dofs[i]);
            if (is_done[index]) // in another cell
              continue;
            is_done[index] = true;
            const Point<dim> position =
              mapping[cell->active_fe_index()].transform_unit_to_real_cell(
                cell, fe.unit_support_point(i));
            const unsigned int component =
              fe.system_to_component_index(i).first;
            double *const value = space.values.data() + index;
            // of bodies of revolution, too: the others are nearly rigid in
            // parts that are small beside their radius
            for (unsigned int m = 0; m < n_modes; ++m)
              {
                const double motion =
                  rigid_mode<dim>(m, (position - centre) / radius)[component];
                value[m * n_owned] = motion;
                if (colour > 0)
                  value[(n_modes * colour + m) * n_owned] = motion;
              }
          }
      }
    return space;
  }

#define INSTANTIATE(dim)                                                 \
  template std::vector<unsigned int> colour_bodies(                      \
    const Bodies &,                                                      \
    const std::vector<std::unique_ptr<ContactPair<dim>>> &,              \
    const std::vector<bool> &);                                          \
  template NearNullSpace rigid_modes(const hp::MappingCollection<dim> &, \
                                     const DoFHandler<dim> &,            \
                                     const Constraints &,                \
                                     const Bodies &,                     \
                                     const std::vector<unsigned int> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
