#include <stickslip/solid/linear_stiffness.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// The unknowns that stand for @p dof, with their weights.
    void
    resolve(const Constraints            &constraints,
            const types::global_dof_index dof,
            std::vector<std::pair<types::global_dof_index, double>> &unknowns)
    {
      if (!constraints.is_constrained(dof))
        unknowns.assign(1, {dof, 1.});
      else
        unknowns = *constraints.get_constraint_entries(dof);
    }



    bool
    is_symmetric(const FullMatrix<double> &matrix)
    {
      double largest = 0., difference = 0.;
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j <= i; ++j)
          {
            largest = std::max(largest, std::abs(matrix(i, j)));
            difference =
              std::max(difference, std::abs(matrix(i, j) - matrix(j, i)));
          }
      return difference <= 1e-10 * largest;
    }
  } // namespace



  template <int dim>
  void
  LinearStiffness<dim>::number_nodes(const std::vector<CellNodes>    &local,
                                     const std::vector<CellIterator> &cells)
  {
    std::vector<types::global_dof_index> cell_dofs, firsts;
    for (const CellIterator &cell : cells)
      {
        cell_dofs.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(cell_dofs);
        for (const auto &components : local[cell->active_fe_index()])
          firsts.push_back(cell_dofs[components[0]]);
      }
    std::sort(firsts.begin(), firsts.end());
    firsts.erase(std::unique(firsts.begin(), firsts.end()), firsts.end());
    dofs.clear();
    for (const auto first : firsts)
      for (unsigned int c = 0; c < dim; ++c)
        dofs.push_back(first + c);
  }



  template <int dim>
  void
  LinearStiffness<dim>::assemble(const hp::FECollection<dim>     &elements,
                                 const std::vector<CellIterator> &cells,
                                 const CellStiffness             &stiffness_of)
  {
    // deal.II searches a table for each of them
    std::vector<CellNodes> nodes_of_kind(elements.size());
    for (unsigned int kind = 0; kind < elements.size(); ++kind)
      {
        const FiniteElement<dim> &fe = elements[kind];
        nodes_of_kind[kind].resize(fe.base_element(0).n_dofs_per_cell());
        for (unsigned int a = 0; a < nodes_of_kind[kind].size(); ++a)
          for (unsigned int c = 0; c < dim; ++c)
            nodes_of_kind[kind][a][c] = fe.component_to_system_index(c, a);
      }
    number_nodes(nodes_of_kind, cells);

    const unsigned int                   n_nodes = dofs.size() / dim;
    std::vector<types::global_dof_index> cell_dofs, nodes;
    const auto                           read_nodes = [&](const auto &cell) {
      const CellNodes &local = nodes_of_kind[cell->active_fe_index()];
      cell_dofs.resize(dim * local.size());
      nodes.resize(local.size());
      cell->get_dof_indices(cell_dofs);
      for (unsigned int a = 0; a < local.size(); ++a)
        {
          const auto first = cell_dofs[local[a][0]];
          for (unsigned int c = 0; c < dim; ++c)
            AssertDimension(cell_dofs[local[a][c]], first + c);
          nodes[a] =
            (std::lower_bound(dofs.begin(), dofs.end(), first) - dofs.begin()) /
            dim;
        }
    };
    DynamicSparsityPattern pattern(n_nodes);
    for (const CellIterator &cell : cells)
      {
        read_nodes(cell);
        std::sort(nodes.begin(), nodes.end());
        for (auto node = nodes.begin(); node != nodes.end(); ++node)
          pattern.add_entries(*node, node, nodes.end(), true);
      }
    blocks.copy_from(pattern);
    find_mirrored();
    values.assign(blocks.n_nonzero_elements() * dim * dim, 0.);

    FullMatrix<double> stiffness;
    for (const CellIterator &cell : cells)
      {
        const CellNodes   &local = nodes_of_kind[cell->active_fe_index()];
        const unsigned int n     = local.size();
        stiffness.reinit(dim * n, dim * n, true);
        stiffness_of(cell, stiffness);
        AssertThrow(is_symmetric(stiffness),
                    ExcMessage("A law that says that it is linear has an "
                               "unsymmetric tangent."));
        read_nodes(cell);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            {
              if (nodes[b] < nodes[a])
                continue;
              double *const block =
                values.data() + blocks(nodes[a], nodes[b]) * dim * dim;
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int k = 0; k < dim; ++k)
                  block[i * dim + k] += stiffness(local[a][i], local[b][k]);
            }
      }
  }



  template <int dim>
  void
  LinearStiffness<dim>::find_mirrored()
  {
    mirrored_begins.assign(blocks.n_rows() + 2, 0);
    for (unsigned int node = 0; node < blocks.n_rows(); ++node)
      for (auto entry = blocks.begin(node); entry != blocks.end(node); ++entry)
        if (entry->column() != node)
          ++mirrored_begins[entry->column() + 2];
    std::partial_sum(mirrored_begins.begin(),
                     mirrored_begins.end(),
                     mirrored_begins.begin());
    mirrored.resize(mirrored_begins.back());
    // filling moves each begin to its end, which is the next one's begin
    for (unsigned int node = 0; node < blocks.n_rows(); ++node)
      for (auto entry = blocks.begin(node); entry != blocks.end(node); ++entry)
        if (entry->column() != node)
          mirrored[mirrored_begins[entry->column() + 1]++] = {
            node, static_cast<unsigned int>(entry->global_index())};
    mirrored_begins.pop_back();
  }



  template <int dim>
  void
  LinearStiffness<dim>::vmult(Vector<double> &y, const Vector<double> &x) const
  {
    y = 0.;
    for (unsigned int node = 0; node < blocks.n_rows(); ++node)
      {
        const double *const x_node   = x.begin() + node * dim;
        double              sum[dim] = {};
        for (auto entry = blocks.begin(node); entry != blocks.end(node);
             ++entry)
          {
            const double *const block =
              values.data() + entry->global_index() * dim * dim;
            const double *const x_other = x.begin() + entry->column() * dim;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int k = 0; k < dim; ++k)
                sum[i] += block[i * dim + k] * x_other[k];
            if (entry->column() == node)
              continue;
            double *const y_other = y.begin() + entry->column() * dim;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int k = 0; k < dim; ++k)
                y_other[k] += block[i * dim + k] * x_node[i];
          }
        for (unsigned int i = 0; i < dim; ++i)
          y(node * dim + i) += sum[i];
      }
  }



  template <int dim>
  void
  LinearStiffness<dim>::add_forces(const LA::Vector  &u,
                                   const Constraints &geometric,
                                   LA::Vector        &internal) const
  {
    if (dofs.empty())
      return;
    Vector<double> x(dofs.size()), forces(dofs.size());
    u.extract_subvector_to(dofs.begin(), dofs.end(), x.begin());
    vmult(forces, x);
    geometric.distribute_local_to_global(forces, dofs, internal);
  }



  template <int dim>
  void
  LinearStiffness<dim>::add_tangent(const LA::Vector  &u,
                                    const Constraints &constraints,
                                    LA::SparseMatrix  &matrix,
                                    LA::Vector        &rhs) const
  {
    if (dofs.empty())
      return;
    // What is prescribed moves the other nodes, too: -K (u + prescribed).
    Vector<double> x(dofs.size()), forces(dofs.size());
    u.extract_subvector_to(dofs.begin(), dofs.end(), x.begin());
    for (unsigned int k = 0; k < dofs.size(); ++k)
      x(k) += constraints.get_inhomogeneity(dofs[k]);
    vmult(forces, x);
    forces *= -1.;
    constraints.distribute_local_to_global(forces, dofs, rhs);

    LA::RowAdder                                            adder(matrix);
    std::vector<std::pair<types::global_dof_index, double>> rows, unknowns;
    std::vector<types::global_dof_index>                    columns;
    struct Source // of a column
    {
      std::size_t  first;  // in the values
      unsigned int stride; // from row to row of the block
      double       weight;
    };
    std::vector<Source> sources;
    std::vector<double> row;
    for (unsigned int node = 0; node < blocks.n_rows(); ++node)
      {
        columns.clear();
        sources.clear();
        const auto add_block = [&](const unsigned int column,
                                   const std::size_t  block,
                                   const bool         is_transposed) {
          for (unsigned int c = 0; c < dim; ++c)
            {
              resolve(constraints, dofs[column * dim + c], unknowns);
              for (const auto &[unknown, weight] : unknowns)
                {
                  columns.push_back(unknown);
                  sources.push_back(
                    {block * dim * dim + (is_transposed ? c * dim : c),
                     is_transposed ? 1U : dim,
                     weight});
                }
            }
        };
        for (auto k = mirrored_begins[node]; k < mirrored_begins[node + 1]; ++k)
          add_block(mirrored[k].column, mirrored[k].block, true);
        for (auto entry = blocks.begin(node); entry != blocks.end(node);
             ++entry)
          add_block(entry->column(), entry->global_index(), false);
        adder.set_columns(columns);
        for (unsigned int i = 0; i < dim; ++i)
          {
            const auto dof = dofs[node * dim + i];
            if (constraints.is_constrained(dof))
              matrix.add(dof,
                         dof,
                         values[blocks(node, node) * dim * dim + i * dim + i]);
            resolve(constraints, dof, rows);
            if (rows.empty())
              continue;
            row.clear();
            for (const Source &source : sources)
              row.push_back(source.weight *
                            values[source.first + i * source.stride]);
            for (const auto &[index, weight] : rows)
              adder.add(index, row, weight);
          }
      }
  }

  template class LinearStiffness<2>;
  template class LinearStiffness<3>;
} // namespace stickslip
