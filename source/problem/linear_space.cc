#include <stickslip/problem/linear_space.h>

#include <deal.II/dofs/dof_tools.h>

#include <cmath>
#include <map>
#include <vector>

namespace stickslip
{
  template <int dim>
  LinearSpace<dim>::LinearSpace(const DofLayout<dim> &fine,
                                const MPI_Comm       &communicator)
    : fine(fine)
    , elements(make_vector_elements<dim>(fine.kinds, 1))
    , dof_handler(fine.dof_handler.get_triangulation())
    , communicator(communicator)
  {
    distribute_dofs(elements, dof_handler);
    owned = dof_handler.locally_owned_dofs();
  }



  template <int dim>
  void
  LinearSpace<dim>::constrain(const Constraints &fine_constraints)
  {
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    lines.reinit(relevant);
    DoFTools::make_hanging_node_constraints(dof_handler, lines);

    std::map<types::global_dof_index, types::global_dof_index> linear_dof;
    for (const auto &cell : fine.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const typename DoFHandler<dim>::active_cell_iterator coarse(
            &dof_handler.get_triangulation(),
            cell->level(),
            cell->index(),
            &dof_handler);
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int c = 0; c < dim; ++c)
              linear_dof[cell->vertex_dof_index(v, c)] =
                coarse->vertex_dof_index(v, c);
        }
    for (const auto &[fine_dof, dof] : linear_dof)
      if (fine_constraints.is_constrained(fine_dof) &&
          !lines.is_constrained(dof))
        {
          lines.add_line(dof);
          const auto *entries =
            fine_constraints.get_constraint_entries(fine_dof);
          if (entries != nullptr)
            for (const auto &[other, weight] : *entries)
              {
                // what is out of sight only makes the preconditioner stiffer
                const auto known = linear_dof.find(other);
                if (known != linear_dof.end())
                  lines.add_entry(dof, known->second, weight);
              }
        }
    lines.close();
  }



  template <int dim>
  template <typename Visitor>
  void
  LinearSpace<dim>::visit_rows(const Constraints &fine_constraints,
                               const Visitor     &visit) const
  {
    std::vector<bool>                    done(fine.owned.n_elements(), false);
    std::vector<types::global_dof_index> fine_dofs, dofs;
    std::map<types::global_dof_index, double> row;
    std::vector<types::global_dof_index>      columns;
    std::vector<double>                       values;
    for (const auto &cell : fine.dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const typename DoFHandler<dim>::active_cell_iterator coarse(
          &dof_handler.get_triangulation(),
          cell->level(),
          cell->index(),
          &dof_handler);
        const FiniteElement<dim> &fe      = coarse->get_fe();
        const FiniteElement<dim> &fine_fe = cell->get_fe();
        fine_dofs.resize(fine_fe.n_dofs_per_cell());
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(fine_dofs);
        coarse->get_dof_indices(dofs);
        for (unsigned int i = 0; i < fine_dofs.size(); ++i)
          {
            if (!fine.owned.is_element(fine_dofs[i]) ||
                done[fine.owned.index_within_set(fine_dofs[i])])
              continue;
            done[fine.owned.index_within_set(fine_dofs[i])] = true;
            const unsigned int c = fine_fe.system_to_component_index(i).first;
            const Point<dim>   point = fine_fe.unit_support_point(i);
            const bool held = fine_constraints.is_constrained(fine_dofs[i]);
            row.clear();
            for (const unsigned int v : cell->vertex_indices())
              {
                const unsigned int j     = fe.component_to_system_index(c, v);
                const double       value = fe.shape_value(j, point);
                if (std::abs(value) < 1e-12 || (held && value < 1. - 1e-12))
                  continue;
                if (held || !lines.is_constrained(dofs[j]))
                  row[dofs[j]] += value;
                else if (const auto *entries =
                           lines.get_constraint_entries(dofs[j]))
                  for (const auto &[other, weight] : *entries)
                    row[other] += weight * value;
              }
            columns.clear();
            values.clear();
            for (const auto &[column, value] : row)
              {
                columns.push_back(column);
                values.push_back(value);
              }
            visit(fine_dofs[i], columns, values);
          }
      }
  }



  template <int dim>
  void
  LinearSpace<dim>::update(const Constraints &fine_constraints)
  {
    constrain(fine_constraints);
    // deal.II overflows on a rank that has no rows but expects entries in them
    LA::SparsityPattern pattern(fine.owned,
                                owned,
                                communicator,
                                fine.owned.n_elements() > 0 ? 1u << dim : 0);
    visit_rows(fine_constraints,
               [&](const auto row, const auto &columns, const auto &) {
                 pattern.add_entries(row, columns.begin(), columns.end());
               });
    pattern.compress();
    matrix = std::make_shared<LA::SparseMatrix>();
    matrix->reinit(pattern);
    visit_rows(fine_constraints,
               [&](const auto row, const auto &columns, const auto &values) {
                 matrix->set(row, columns, values, false);
               });
    matrix->compress(VectorOperation::insert);
  }

  template class LinearSpace<2>;
  template class LinearSpace<3>;
} // namespace stickslip
