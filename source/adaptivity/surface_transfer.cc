#include <stickslip/adaptivity/surface_transfer.h>

#include <stickslip/contact/results/contact_results.h>

#include <cmath>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Where the nodes of a slave face are among those of its cell.
    template <int dim>
    std::vector<unsigned int>
    nodes_in_cell(const SurfaceFace<dim>                     &face,
                  const FiniteElement<dim>                   &fe,
                  const std::vector<types::global_dof_index> &dofs)
    {
      std::map<types::global_dof_index, unsigned int> node_at;
      for (unsigned int i = 0; i < dofs.size(); ++i)
        node_at[dofs[i]] = fe.system_to_component_index(i).second;
      std::vector<unsigned int> nodes;
      for (unsigned int j = 0; j < face.n_nodes; ++j)
        nodes.push_back(node_at.at(face.dofs[j * dim]));
      return nodes;
    }



    /// The slave faces of each cell, as (pair, face).
    template <int dim>
    using FacesOfCells = std::map<std::array<unsigned int, 4>,
                                  std::vector<std::pair<unsigned, unsigned>>>;

    template <int dim>
    FacesOfCells<dim>
    faces_of_cells(const ContactAssembler<dim> &contact)
    {
      FacesOfCells<dim> faces;
      const auto       &pairs = contact.contact_pairs();
      for (unsigned int p = 0; p < pairs.size(); ++p)
        for (unsigned int f = 0; f < pairs[p]->slave_faces.size(); ++f)
          faces[pairs[p]->slave_faces[f].face.id.cell].emplace_back(p, f);
      return faces;
    }



    /// Calls @p visit(cell, pair, face, nodes) for all slave faces of this rank;
    /// @p nodes are those of the face among the nodes of the cell.
    template <int dim, typename Visitor>
    void
    for_each_slave_face(ContactProblem<dim> &problem, const Visitor &visit)
    {
      const DofLayout<dim> &layout = problem.layout();
      const auto           &pairs  = problem.contact().contact_pairs();
      const auto            faces  = faces_of_cells(problem.contact());
      std::vector<types::global_dof_index> dofs(layout.fe().dofs_per_cell);
      for (const auto &cell : layout.dof_handler.active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          const auto found = faces.find(cell->id().template to_binary<dim>());
          if (found == faces.end())
            continue;
          cell->get_dof_indices(dofs);
          for (const auto &[p, f] : found->second)
            visit(cell,
                  p,
                  f,
                  nodes_in_cell(pairs[p]->slave_faces[f].face,
                                layout.fe(),
                                dofs));
        }
    }



    /// The values of the surface of pair @p p in @p record, made if missing.
    CellRecord::NodalField &
    surface_of(CellRecord        &record,
               const unsigned int p,
               const std::size_t  n_values)
    {
      for (auto &surface : record.on_surfaces)
        if (surface.pair == p)
          return surface.values;
      record.on_surfaces.push_back({p, CellRecord::NodalField(n_values, 0.)});
      return record.on_surfaces.back().values;
    }



    /// Of one state: lambda_n and Lambda at a multiplier node, from those at
    /// the displacement nodes of the face.
    template <int dim>
    std::pair<double, Tensor<1, dim>>
    at_multiplier_node(const ContactPair<dim>                &pair,
                       const std::vector<CarriedValues<dim>> &nodes,
                       const WhichState                       state,
                       const unsigned int                     l)
    {
      std::vector<double> N;
      pair.displacement_shape.evaluate_values(pair.multiplier_shape.node(l), N);
      double         lambda_n = 0.;
      Tensor<1, dim> Lambda;
      for (unsigned int j = 0; j < nodes.size(); ++j)
        {
          lambda_n += N[j] * nodes[j].lambda_n[state];
          Lambda += N[j] * nodes[j].Lambda[state];
        }
      return {lambda_n, Lambda};
    }



    /// lambda_n of all multiplier nodes, into block 1 of a state.
    template <int dim>
    void
    set_normal_multipliers(const ContactAssembler<dim> &contact,
                           const AllCarriedValues<dim> &all,
                           const WhichState             state,
                           LA::Vector                  &multipliers)
    {
      for (unsigned int p = 0; p < all.size(); ++p)
        {
          const ContactPair<dim> &pair   = *contact.contact_pairs()[p];
          const unsigned int      n_comp = pair.n_multiplier_components();
          for (unsigned int f = 0; f < all[p].size(); ++f)
            for (unsigned int l = 0; l < pair.multiplier_shape.n_nodes(); ++l)
              multipliers(pair.slave_faces[f].multiplier_dofs[l * n_comp]) =
                at_multiplier_node(pair, all[p][f], state, l).first;
        }
      multipliers.compress(VectorOperation::insert);
    }



    /// Lambda in the frames that the nodes have in the present configuration.
    template <int dim>
    void
    set_friction_multipliers(const ContactAssembler<dim> &contact,
                             const AllCarriedValues<dim> &all,
                             const WhichState             state,
                             LA::Vector                  &multipliers)
    {
      LA::Vector sum(multipliers), weights(multipliers);
      sum     = 0.;
      weights = 0.;
      for (unsigned int p = 0; p < all.size(); ++p)
        {
          const ContactPair<dim> &pair   = *contact.contact_pairs()[p];
          const unsigned int      n_comp = pair.n_multiplier_components();
          if (n_comp == 1)
            continue;
          for (const ContactPoint<dim> &point : pair.points)
            {
              if (!point.pairing.paired)
                continue;
              const unsigned int f = point.geometry.slave_face;
              const auto        &L =
                pair.table.multiplier[point.geometry.quadrature_index];
              for (unsigned int l = 0; l < L.size(); ++l)
                {
                  const Tensor<1, dim> Lambda =
                    at_multiplier_node(pair, all[p][f], state, l).second;
                  const double weight = std::abs(L[l]) * point.geometry.weight;
                  for (unsigned int b = 0; b + 1 < n_comp; ++b)
                    {
                      const auto i =
                        pair.slave_faces[f].multiplier_dofs[l * n_comp + 1 + b];
                      for (unsigned int a = 0; a < dim - 1; ++a)
                        sum(i) += weight * point.nodal_rotations[l][a][b] *
                                  (point.pairing.tau[a] * Lambda);
                      weights(i) += weight;
                    }
                }
            }
        }
      sum.compress(VectorOperation::add);
      weights.compress(VectorOperation::add);
      for (const auto i : contact.multipliers().locally_owned())
        if (weights(i) > 0.)
          multipliers(i) = sum(i) / weights(i);
      multipliers.compress(VectorOperation::insert);
    }
  } // namespace



  template <int dim>
  void
  add_surfaces(ContactProblem<dim>      &problem,
               const ContactStates<dim> &results,
               std::vector<CellRecord>  &records)
  {
    // the results are in the order of pairs and faces
    std::vector<std::size_t> first(1, 0);
    for (const auto &pair : problem.contact().contact_pairs())
      first.push_back(first.back() + pair->slave_faces.size());
    const unsigned int n_nodes = problem.layout().fe().dofs_per_cell / dim;
    for_each_slave_face(
      problem,
      [&](const auto                      &cell,
          const unsigned int               p,
          const unsigned int               f,
          const std::vector<unsigned int> &nodes) {
        const auto &result = results[accepted_state][first[p] + f];
        const auto &guess  = results[guessed_state][first[p] + f];
        const auto  slip =
          nodal_averages(result, &ContactPointResult<dim>::accumulated_slip);
        auto &values = surface_of(records[cell->active_cell_index()],
                                  p,
                                  n_nodes * CarriedValues<dim>::n_components);
        for (unsigned int j = 0; j < nodes.size(); ++j)
          {
            CarriedValues<dim> at_node{{{result.lambda_n[j],
                                         guess.lambda_n[j]}},
                                       {{result.Lambda[j], guess.Lambda[j]}},
                                       slip[j]};
            at_node.for_each_component(
              [&](const unsigned int c, const double value) {
                values[c * n_nodes + nodes[j]] = value;
              });
          }
      });
  }



  template <int dim>
  AllCarriedValues<dim>
  carried_values(ContactProblem<dim>           &problem,
                 const std::vector<CellRecord> &records)
  {
    const auto           &pairs   = problem.contact().contact_pairs();
    const unsigned int    n_nodes = problem.layout().fe().dofs_per_cell / dim;
    AllCarriedValues<dim> all(pairs.size());
    for (unsigned int p = 0; p < pairs.size(); ++p)
      all[p].resize(pairs[p]->slave_faces.size());
    for_each_slave_face(problem,
                        [&](const auto                      &cell,
                            const unsigned int               p,
                            const unsigned int               f,
                            const std::vector<unsigned int> &nodes) {
                          all[p][f].resize(nodes.size());
                          // a surface that no cell had there before has nothing
                          for (const auto &surface :
                               records[cell->active_cell_index()].on_surfaces)
                            if (surface.pair == p)
                              for (unsigned int j = 0; j < nodes.size(); ++j)
                                all[p][f][j].for_each_component(
                                  [&](const unsigned int c, double &value) {
                                    value =
                                      surface.values[c * n_nodes + nodes[j]];
                                  });
                        });
    return all;
  }



  template <int dim>
  void
  set_slip(const ContactAssembler<dim> &contact,
           const AllCarriedValues<dim> &all)
  {
    for (unsigned int p = 0; p < all.size(); ++p)
      {
        ContactPair<dim> &pair = *contact.contact_pairs()[p];
        for (ContactPoint<dim> &point : pair.points)
          {
            const auto &N =
              pair.table.displacement[point.geometry.quadrature_index].value;
            const auto &nodes      = all[p][point.geometry.slave_face];
            point.accumulated_slip = Tensor<1, dim>();
            for (unsigned int j = 0; j < nodes.size(); ++j)
              point.accumulated_slip += N[j] * nodes[j].slip;
          }
      }
  }



  template <int dim>
  void
  set_multipliers(ContactProblem<dim>         &problem,
                  const AllCarriedValues<dim> &all,
                  const WhichState             state,
                  const double                 time,
                  LA::BlockVector             &x)
  {
    set_normal_multipliers(problem.contact(), all, state, x.block(1));
    problem.begin_step(time, x);
    problem.begin_iteration(x); // pairs the points and turns the frames
    set_friction_multipliers(problem.contact(), all, state, x.block(1));
    // multipliers that follow others, or are zero
    LA::BlockVector constrained(x);
    problem.distribute(constrained);
    x.block(1) = constrained.block(1);
    problem.begin_step(time, x);
    problem.begin_iteration(x);
  }

#define INSTANTIATE(dim)                                                  \
  template void                  add_surfaces(ContactProblem<dim> &,      \
                                              const ContactStates<dim> &, \
                                              std::vector<CellRecord> &); \
  template AllCarriedValues<dim> carried_values(                          \
    ContactProblem<dim> &, const std::vector<CellRecord> &);              \
  template void set_slip(const ContactAssembler<dim> &,                   \
                         const AllCarriedValues<dim> &);                  \
  template void set_multipliers(ContactProblem<dim> &,                    \
                                const AllCarriedValues<dim> &,            \
                                const WhichState,                         \
                                const double,                             \
                                LA::BlockVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
