#include <stickslip/adaptivity/state_transfer.h>

#include <stickslip/contact/results/contact_results.h>

#include <stickslip/mesh/agreed_flags.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/array_view.h>

#include <deal.II/distributed/cell_data_transfer.templates.h>

#include <cmath>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    template <int dim>
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    /// What a node of a slave surface has in a record: lambda_n, Lambda and the
    /// accumulated slip as vectors, whose components no frame changes.
    template <int dim>
    struct SurfaceValues
    {
      static constexpr unsigned int n_components = 1 + 2 * dim;

      double         lambda_n = 0.;
      Tensor<1, dim> Lambda;
      Tensor<1, dim> slip;

      /// Calls @p visit(component, value).
      template <typename Visitor>
      void
      for_each_component(const Visitor &visit)
      {
        visit(0, lambda_n);
        for (unsigned int c = 0; c < dim; ++c)
          {
            visit(1 + c, Lambda[c]);
            visit(1 + dim + c, slip[c]);
          }
      }
    };



    /// The node of the scalar element that the dof @p i of a cell is at.
    template <int dim>
    unsigned int
    node_of(const FiniteElement<dim> &fe, const unsigned int i)
    {
      return fe.system_to_component_index(i).second;
    }



    /// Where the nodes of a slave face are among those of its cell.
    template <int dim>
    std::vector<unsigned int>
    nodes_in_cell(const SurfaceFace<dim>                     &face,
                  const FiniteElement<dim>                   &fe,
                  const std::vector<types::global_dof_index> &dofs)
    {
      std::map<types::global_dof_index, unsigned int> node_at;
      for (unsigned int i = 0; i < dofs.size(); ++i)
        node_at[dofs[i]] = node_of(fe, i);
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



    /// Adds what @p results say to the records of the cells.
    template <int dim>
    void
    add_surfaces(ContactProblem<dim> &problem, std::vector<CellRecord> &records)
    {
      const DofLayout<dim> &layout  = problem.layout();
      const auto           &pairs   = problem.contact().contact_pairs();
      const auto            results = contact_results(problem.contact());
      const auto            faces   = faces_of_cells(problem.contact());
      // the results are in the order of pairs and faces
      std::vector<std::size_t> first(1, 0);
      for (const auto &pair : pairs)
        first.push_back(first.back() + pair->slave_faces.size());
      const unsigned int n_nodes = layout.fe.dofs_per_cell / dim;
      std::vector<types::global_dof_index> dofs(layout.fe.dofs_per_cell);
      for (const auto &cell : layout.dof_handler.active_cell_iterators())
        {
          const auto found =
            cell->is_locally_owned()
              ? faces.find(cell->id().template to_binary<dim>())
              : faces.end();
          if (found == faces.end())
            continue;
          cell->get_dof_indices(dofs);
          for (const auto &[p, f] : found->second)
            {
              const auto &result = results[first[p] + f];
              const auto  nodes =
                nodes_in_cell(pairs[p]->slave_faces[f].face, layout.fe, dofs);
              const auto slip =
                nodal_averages(result,
                               &ContactPointResult<dim>::accumulated_slip);
              auto &values =
                surface_of(records[cell->active_cell_index()],
                           p,
                           n_nodes * SurfaceValues<dim>::n_components);
              for (unsigned int j = 0; j < nodes.size(); ++j)
                {
                  SurfaceValues<dim> at_node{result.lambda_n[j],
                                             result.Lambda[j],
                                             slip[j]};
                  at_node.for_each_component(
                    [&](const unsigned int c, const double value) {
                      values[c * n_nodes + nodes[j]] = value;
                    });
                }
            }
        }
    }



    /// What the records have on the nodes of all slave faces of this rank:
    /// [pair][face][node].
    template <int dim>
    using AllSurfaceValues =
      std::vector<std::vector<std::vector<SurfaceValues<dim>>>>;

    template <int dim>
    AllSurfaceValues<dim>
    surface_values(ContactProblem<dim>           &problem,
                   const std::vector<CellRecord> &records)
    {
      const DofLayout<dim> &layout  = problem.layout();
      const auto           &pairs   = problem.contact().contact_pairs();
      const auto            faces   = faces_of_cells(problem.contact());
      const unsigned int    n_nodes = layout.fe.dofs_per_cell / dim;
      AllSurfaceValues<dim> all(pairs.size());
      for (unsigned int p = 0; p < pairs.size(); ++p)
        all[p].resize(pairs[p]->slave_faces.size());
      std::vector<types::global_dof_index> dofs(layout.fe.dofs_per_cell);
      for (const auto &cell : layout.dof_handler.active_cell_iterators())
        {
          const auto found =
            cell->is_locally_owned()
              ? faces.find(cell->id().template to_binary<dim>())
              : faces.end();
          if (found == faces.end())
            continue;
          cell->get_dof_indices(dofs);
          CellRecord record = records[cell->active_cell_index()];
          for (const auto &[p, f] : found->second)
            {
              const auto &values =
                surface_of(record,
                           p,
                           n_nodes * SurfaceValues<dim>::n_components);
              for (const unsigned int node : nodes_in_cell(
                     pairs[p]->slave_faces[f].face, layout.fe, dofs))
                {
                  SurfaceValues<dim> at_node;
                  at_node.for_each_component(
                    [&](const unsigned int c, double &value) {
                      value = values[c * n_nodes + node];
                    });
                  all[p][f].push_back(at_node);
                }
            }
        }
      return all;
    }



    /// Of a multiplier node with functions of its own: its values, from those
    /// at the displacement nodes of the face.
    template <int dim>
    SurfaceValues<dim>
    at_multiplier_node(const ContactPair<dim>                &pair,
                       const std::vector<SurfaceValues<dim>> &nodes,
                       const unsigned int                     l)
    {
      std::vector<double> N;
      pair.displacement_shape.evaluate_values(pair.multiplier_shape.node(l), N);
      SurfaceValues<dim> values;
      for (unsigned int j = 0; j < nodes.size(); ++j)
        {
          values.lambda_n += N[j] * nodes[j].lambda_n;
          values.Lambda += N[j] * nodes[j].Lambda;
        }
      return values;
    }



    /// lambda_n of all multiplier nodes, into block 1 of a state.
    template <int dim>
    void
    set_normal_multipliers(const ContactAssembler<dim> &contact,
                           const AllSurfaceValues<dim> &all,
                           LA::Vector                  &multipliers)
    {
      for (unsigned int p = 0; p < all.size(); ++p)
        {
          const ContactPair<dim> &pair   = *contact.contact_pairs()[p];
          const unsigned int      n_comp = pair.n_multiplier_components();
          for (unsigned int f = 0; f < all[p].size(); ++f)
            for (unsigned int l = 0; l < pair.multiplier_shape.n_nodes(); ++l)
              multipliers(pair.slave_faces[f].multiplier_dofs[l * n_comp]) =
                at_multiplier_node(pair, all[p][f], l).lambda_n;
        }
      multipliers.compress(VectorOperation::insert);
    }



    /// Lambda in the frames that the nodes have in the present configuration,
    /// and the slip of the points.
    template <int dim>
    void
    set_friction(ContactAssembler<dim>       &contact,
                 const AllSurfaceValues<dim> &all,
                 LA::Vector                  &multipliers)
    {
      LA::Vector sum(multipliers), weights(multipliers);
      sum     = 0.;
      weights = 0.;
      for (unsigned int p = 0; p < all.size(); ++p)
        {
          const ContactPair<dim> &pair   = *contact.contact_pairs()[p];
          const unsigned int      n_comp = pair.n_multiplier_components();
          for (ContactPoint<dim> &point : contact.contact_pairs()[p]->points)
            {
              const unsigned int f     = point.geometry.slave_face;
              const auto        &nodes = all[p][f];
              const auto        &N =
                pair.table.displacement[point.geometry.quadrature_index].value;
              const auto &L =
                pair.table.multiplier[point.geometry.quadrature_index];
              point.accumulated_slip = Tensor<1, dim>();
              for (unsigned int j = 0; j < nodes.size(); ++j)
                point.accumulated_slip += N[j] * nodes[j].slip;
              if (n_comp == 1 || !point.pairing.paired)
                continue;
              for (unsigned int l = 0; l < L.size(); ++l)
                {
                  const Tensor<1, dim> Lambda =
                    at_multiplier_node(pair, nodes, l).Lambda;
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
  StateTransfer<dim>::StateTransfer(ContactProblem<dim>   &problem,
                                    const double           time,
                                    const LA::BlockVector &x,
                                    const LA::Vector      &rate)
    : element(
        make_element<dim>(problem.layout().cells, problem.layout().fe.degree))
    , transfer(*element, problem.solid().cell_quadrature())
  {
    const DofLayout<dim> &layout = problem.layout();
    problem.restore();
    problem.begin_step(time, x);
    problem.configure(x, true);
    const auto ghosted = [&](const LA::Vector &owned) {
      LA::Vector with_ghosts(layout.owned,
                             layout.relevant,
                             problem.contact().get_communicator());
      with_ghosts = owned;
      return with_ghosts;
    };
    const std::array<LA::Vector, 2> fields{
      {ghosted(x.block(0)), ghosted(rate)}};
    const unsigned int n_dofs = layout.fe.dofs_per_cell, n_nodes = n_dofs / dim;
    std::vector<types::global_dof_index> dofs(n_dofs);
    records.resize(layout.dof_handler.get_triangulation().n_active_cells());
    for (const auto &cell : layout.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          CellRecord &record = records[cell->active_cell_index()];
          record.in_body.resize(fields.size() * n_dofs);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < n_dofs; ++i)
            {
              const auto [component, node] =
                layout.fe.system_to_component_index(i);
              for (unsigned int k = 0; k < fields.size(); ++k)
                record.in_body[(k * dim + component) * n_nodes + node] =
                  fields[k](dofs[i]);
            }
          const auto history = problem.solid().point_history().accepted_of_cell(
            cell->active_cell_index());
          record.history.assign(history.begin(), history.end());
        }
    add_surfaces(problem, records);
  }



  template <int dim>
  void
  StateTransfer<dim>::execute(
    parallel::distributed::Triangulation<dim> &triangulation)
  {
    using Cell = typename Triangulation<dim>::cell_iterator;
    parallel::distributed::CellDataTransfer<dim, dim, std::vector<CellRecord>>
      data(
        triangulation,
        /*transfer_variable_size_data=*/true,
        [this](const Cell &, const CellRecord parent) {
          return transfer.to_children(parent);
        },
        [this](const Cell &, const std::vector<CellRecord> &children) {
          return transfer.to_parent(children);
        });
    data.prepare_for_coarsening_and_refinement(records);
    execute_agreed_flags(triangulation);
    std::vector<CellRecord> moved(triangulation.n_active_cells());
    data.unpack(moved);
    records = std::move(moved);
  }



  template <int dim>
  void
  StateTransfer<dim>::put_into(ContactProblem<dim> &problem,
                               const double         time,
                               LA::BlockVector     &x,
                               LA::Vector          &rate) const
  {
    const DofLayout<dim> &layout = problem.layout();
    const unsigned int n_dofs = layout.fe.dofs_per_cell, n_nodes = n_dofs / dim;
    x    = problem.zero_state();
    rate = x.block(0);
    const std::array<LA::Vector *, 2>    fields{{&x.block(0), &rate}};
    std::vector<types::global_dof_index> dofs(n_dofs);
    for (const auto &cell : layout.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const CellRecord &record = records[cell->active_cell_index()];
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < n_dofs; ++i)
            if (layout.owned.is_element(dofs[i]))
              {
                const auto [component, node] =
                  layout.fe.system_to_component_index(i);
                for (unsigned int k = 0; k < fields.size(); ++k)
                  (*fields[k])(dofs[i]) =
                    record.in_body[(k * dim + component) * n_nodes + node];
              }
          problem.solid().point_history().set_cell(
            cell->active_cell_index(),
            ArrayView<const double>(record.history.data(),
                                    record.history.size()));
        }
    for (LA::Vector *field : fields)
      {
        field->compress(VectorOperation::insert);
        problem.make_conforming(*field);
      }
    const auto all = surface_values(problem, records);
    set_normal_multipliers(problem.contact(), all, x.block(1));
    problem.restore();
    problem.begin_step(time, x);
    problem.begin_iteration(x); // pairs the points and turns the frames
    set_friction(problem.contact(), all, x.block(1));
    // multipliers that follow others, or are zero
    LA::BlockVector constrained(x);
    problem.distribute(constrained);
    x.block(1) = constrained.block(1);
    problem.begin_step(time, x);
    problem.begin_iteration(x);
  }

  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace stickslip
