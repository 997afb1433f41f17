#include <stickslip/adaptivity/state_transfer.h>

#include <stickslip/adaptivity/surface_transfer.h>

#include <stickslip/contact/results/contact_results.h>

#include <stickslip/mesh/agreed_flags.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/utilities.h>

#include <array>
#include <utility>

namespace stickslip
{
  template <int dim>
  StateTransfer<dim>::StateTransfer(ContactProblem<dim>  &problem,
                                    const double          time,
                                    const MeshState      &state,
                                    const Vector<double> &indicators)
    : element(
        make_element<dim>(problem.layout().cells(), problem.layout().degree()))
    , transfer(*element,
               cell_quadrature<dim>(problem.layout().cells(),
                                    problem.layout().degree()))
  {
    const DofLayout<dim> &layout = problem.layout();
    ContactStates<dim>    results;
    problem.restore();
    for (const WhichState k : {accepted_state, guessed_state})
      {
        const LA::BlockVector &x = k == accepted_state ? state.x : state.guess;
        problem.begin_step(time, x);
        problem.configure(x, true);
        results[k] = contact_results(problem.contact());
      }
    const auto ghosted = [&](const LA::Vector &owned) {
      LA::Vector with_ghosts(layout.owned,
                             layout.relevant,
                             problem.contact().get_communicator());
      with_ghosts = owned;
      return with_ghosts;
    };
    const std::array<LA::Vector, 3> fields{{ghosted(state.x.block(0)),
                                            ghosted(state.rate),
                                            ghosted(state.guess.block(0))}};
    const unsigned int              n_dofs = layout.fe().dofs_per_cell,
                       n_nodes             = n_dofs / dim;
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
                layout.fe().system_to_component_index(i);
              for (unsigned int k = 0; k < fields.size(); ++k)
                record.in_body[(k * dim + component) * n_nodes + node] =
                  fields[k](dofs[i]);
            }
          const auto history = problem.solid().point_history().accepted_of_cell(
            cell->active_cell_index());
          record.history.assign(history.begin(), history.end());
          if (indicators.size() > 0)
            record.indicator = indicators[cell->active_cell_index()];
        }
    add_surfaces(problem, results, records);
  }



  template <int dim>
  std::vector<CellRecord>
  StateTransfer<dim>::records_of_children(
    const typename Triangulation<dim>::cell_iterator &parent) const
  {
    std::vector<CellRecord> children;
    for (const auto &child : parent->child_iterators())
      children.push_back(records[child->active_cell_index()]);
    return children;
  }



  template <int dim>
  void
  StateTransfer<dim>::execute(
    parallel::distributed::Triangulation<dim> &triangulation)
  {
    using Cell = typename Triangulation<dim>::cell_iterator;
    // A cell with children becomes one without, or has just got them. Not
    // deal.II's CellDataTransfer, which compresses records of different
    // lengths: a tenth of the time of adaptive runs in the plane.
    const auto handle = triangulation.register_data_attach(
      [this](const Cell &cell, const auto) {
        return Utilities::pack(cell->has_children()
                                 ? transfer.to_parent(records_of_children(cell))
                                 : records[cell->active_cell_index()],
                               /*allow_compression=*/false);
      },
      /*returns_variable_size_data=*/true);
    execute_agreed_flags(triangulation);
    std::vector<CellRecord> moved(triangulation.n_active_cells());
    triangulation.notify_ready_to_unpack(
      handle, [this, &moved](const Cell &cell, const auto, const auto &range) {
        auto record =
          Utilities::unpack<CellRecord>(range.begin(),
                                        range.end(),
                                        /*allow_compression=*/false);
        if (!cell->has_children())
          moved[cell->active_cell_index()] = std::move(record);
        else
          {
            auto of_children = transfer.to_children(record);
            for (unsigned int c = 0; c < cell->n_children(); ++c)
              moved[cell->child(c)->active_cell_index()] =
                std::move(of_children[c]);
          }
      });
    records = std::move(moved);
  }



  template <int dim>
  Vector<double>
  StateTransfer<dim>::expected_indicators() const
  {
    Vector<double> indicators(records.size());
    for (unsigned int i = 0; i < records.size(); ++i)
      indicators[i] = records[i].indicator;
    return indicators;
  }



  template <int dim>
  MeshState
  StateTransfer<dim>::put_into(ContactProblem<dim> &problem,
                               const double         time) const
  {
    const DofLayout<dim> &layout           = problem.layout();
    const unsigned int    n_dofs           = layout.fe().dofs_per_cell,
                       n_nodes             = n_dofs / dim;
    const LA::BlockVector             zero = problem.zero_state();
    MeshState                         state{zero, zero.block(0), zero};
    const std::array<LA::Vector *, 3> fields{
      {&state.x.block(0), &state.rate, &state.guess.block(0)}};
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
                  layout.fe().system_to_component_index(i);
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
    const auto all = carried_values(problem, records);
    set_slip(problem.contact(), all);
    problem.restore();
    set_multipliers(problem, all, guessed_state, time, state.guess);
    set_multipliers(problem, all, accepted_state, time, state.x);
    return state;
  }

  template class StateTransfer<2>;
  template class StateTransfer<3>;
} // namespace stickslip
