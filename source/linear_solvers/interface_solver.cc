#include <stickslip/linear_solvers/interface_solver.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Throws NoConvergence if there is an error.
    void
    check(const FactorizationError &error)
    {
      throw_if_failed(error,
                      "Linear solver (block AMG, contact interface)",
                      "the matrix of the interface is singular");
    }
  } // namespace



  InterfaceSolver::InterfaceSolver(const unsigned int largest)
    : largest(largest)
    , first(0)
    , parts(largest)
  {}



  template <typename Visitor>
  void
  InterfaceSolver::visit_interface_row(const LA::BlockSparseMatrix &matrix,
                                       const Row                   &row,
                                       const Visitor               &visit) const
  {
    for (unsigned int c = 0; c < 2; ++c)
      LA::visit_row(matrix.block(row.block, c),
                    row.index,
                    [&](const auto column, const double value) {
                      if (value == 0.)
                        return;
                      const double number = numbers[c](column);
                      if (number > 0.)
                        visit(static_cast<types::global_dof_index>(number -
                                                                   0.5),
                              value);
                    });
  }



  void
  InterfaceSolver::find_surface(const LA::BlockSparseMatrix &matrix)
  {
    surface.clear();
    unsigned int entry = 0;
    for (const auto i : matrix.block(0, 0).locally_owned_range_indices())
      {
        if (LA::row_length(matrix.block(0, 1), i) > 0)
          surface.push_back({0, i, entry});
        ++entry;
      }
    for (const auto i : matrix.block(1, 1).locally_owned_range_indices())
      surface.push_back({1, i, entry++});

    for (unsigned int block = 0; block < 2; ++block)
      {
        const IndexSet owned =
          matrix.block(block, block).locally_owned_range_indices();
        std::vector<types::global_dof_index> seen;
        for (const Row &row : surface)
          LA::visit_row(matrix.block(row.block, block),
                        row.index,
                        [&](const auto column, const double) {
                          if (!owned.is_element(column))
                            seen.push_back(column);
                        });
        std::sort(seen.begin(), seen.end());
        IndexSet needed = owned;
        needed.add_indices(seen.begin(), std::unique(seen.begin(), seen.end()));
        numbers[block].reinit(owned,
                              needed,
                              matrix.block(0, 0).get_mpi_communicator());
      }
  }



  template <typename Value>
  void
  InterfaceSolver::set_numbers(const unsigned int      block,
                               const std::vector<Row> &of_rows,
                               const Value            &value)
  {
    LA::Vector mine(numbers[block].locally_owned_elements(),
                    numbers[block].get_mpi_communicator());
    for (unsigned int k = 0; k < of_rows.size(); ++k)
      if (of_rows[k].block == block)
        mine(of_rows[k].index) = value(k);
    mine.compress(VectorOperation::insert);
    numbers[block] = mine;
  }



  std::vector<InterfaceSolver::Row>
  InterfaceSolver::rows_near_contact(const LA::BlockSparseMatrix &matrix,
                                     const LA::Vector            *also_acting)
  {
    const auto is_any = [](const LA::SparseMatrix       &block,
                           const types::global_dof_index row,
                           const auto                   &condition) {
      bool result = false;
      LA::visit_row(block, row, [&](const auto column, const double value) {
        result = result || condition(column, value);
      });
      return result;
    };
    set_numbers(1, surface, [&](const unsigned int k) {
      return also_acting != nullptr ? (*also_acting)(surface[k].index) : 0.;
    });
    set_numbers(0, surface, [&](const unsigned int k) {
      return is_any(matrix.block(0, 1),
                    surface[k].index,
                    [&](const auto column, const double value) {
                      return value != 0. || numbers[1](column) > 0.;
                    });
    });
    // what the pattern couples: more than neighbours where facets have changed,
    // and whatever a row of B sees
    std::vector<Row> result;
    for (const Row &row : surface)
      if (row.block == 1 || is_any(matrix.block(0, 0),
                                   row.index,
                                   [&](const auto column, const double) {
                                     return numbers[0](column) > 0.;
                                   }))
        result.push_back(row);
    return result;
  }



  void
  InterfaceSolver::number_rows(const MPI_Comm communicator)
  {
    const types::global_dof_index n_owned = rows.size();
    first                                 = 0;
    const int error                       = MPI_Exscan(
      &n_owned, &first, 1, DEAL_II_DOF_INDEX_MPI_TYPE, MPI_SUM, communicator);
    AssertThrowMPI(error);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      first = 0; // MPI leaves it undefined there
    for (unsigned int block = 0; block < 2; ++block)
      set_numbers(block, rows, [&](const unsigned int k) {
        return first + k + 1.;
      });
  }



  void
  InterfaceSolver::make_pattern(const LA::BlockSparseMatrix &matrix)
  {
    const MPI_Comm communicator = matrix.block(0, 0).get_mpi_communicator();
    const types::global_dof_index n_owned = rows.size();
    IndexSet owned(Utilities::MPI::sum(n_owned, communicator));
    owned.add_range(first, first + n_owned);
    std::size_t longest = 0;
    for (const Row &row : rows)
      {
        std::size_t length = 0;
        visit_interface_row(matrix, row, [&](const auto, const double) {
          ++length;
        });
        longest = std::max(longest, length);
      }
    LA::SparsityPattern pattern(owned, owned, communicator, longest);
    std::vector<types::global_dof_index> columns;
    for (unsigned int k = 0; k < rows.size(); ++k)
      {
        columns.clear();
        visit_interface_row(matrix,
                            rows[k],
                            [&](const auto column, const double) {
                              columns.push_back(column);
                            });
        pattern.add_entries(first + k, columns.begin(), columns.end());
      }
    pattern.compress();
    interface.reinit(pattern);
    is_renumbered = false;
    rhs.reinit(owned, communicator);
    solution.reinit(owned, communicator);
  }



  bool
  InterfaceSolver::has_pattern_of(const LA::BlockSparseMatrix &matrix) const
  {
    bool fits = !is_renumbered;

    std::vector<types::global_dof_index> stored;
    for (unsigned int k = 0; k < rows.size() && fits; ++k)
      {
        stored.clear();
        LA::visit_row(interface, first + k, [&](const auto column, double) {
          stored.push_back(column);
        });
        std::sort(stored.begin(), stored.end());
        visit_interface_row(
          matrix, rows[k], [&](const auto column, const double) {
            fits =
              fits && std::binary_search(stored.begin(), stored.end(), column);
          });
      }
    return Utilities::MPI::min<int>(fits,
                                    matrix.block(0, 0).get_mpi_communicator());
  }



  void
  InterfaceSolver::fill(const LA::BlockSparseMatrix &matrix)
  {
    interface = 0.;
    std::vector<types::global_dof_index> columns;
    std::vector<double>                  values;
    for (unsigned int k = 0; k < rows.size(); ++k)
      {
        columns.clear();
        values.clear();
        visit_interface_row(matrix,
                            rows[k],
                            [&](const auto column, const double value) {
                              columns.push_back(column);
                              values.push_back(value);
                            });
        interface.set(first + k, columns, values, false);
      }
    interface.compress(VectorOperation::insert);
  }



  bool
  InterfaceSolver::determine_unknowns(const LA::BlockSparseMatrix &matrix,
                                      const bool                   new_layout,
                                      const LA::Vector            *also_acting)
  {
    const MPI_Comm communicator = matrix.block(0, 0).get_mpi_communicator();
    if (new_layout)
      find_surface(matrix);
    std::vector<Row> now = rows_near_contact(matrix, also_acting);
    const bool       has_changed =
      Utilities::MPI::max<int>(new_layout || now != rows, communicator);
    is_renumbered = is_renumbered || has_changed;
    rows          = std::move(now);
    number_rows(communicator);
    return has_changed;
  }



  void
  InterfaceSolver::factorise(const LA::BlockSparseMatrix &matrix)
  {
    if (!is_large() && has_pattern_of(matrix))
      {
        fill(matrix);
        if (!factorization.refactorise())
          return;
      }
    factorization.clear();
    parts.clear();
    make_pattern(matrix);
    fill(matrix);
    if (!is_large())
      {
        check(factorization.factorise(interface));
        return;
      }
    std::vector<bool> is_multiplier;
    for (const Row &row : rows)
      is_multiplier.push_back(row.block == 1);
    check(parts.factorise(interface, is_multiplier));
  }



  OwnedEntries
  InterfaceSolver::marks(const unsigned int n) const
  {
    OwnedEntries marks(n, 0.);
    for (const Row &row : rows)
      marks[row.entry] = 1.;
    return marks;
  }



  void
  InterfaceSolver::solve(OwnedEntries &x, const OwnedEntries &residual)
  {
    // without compress(), which asks all ranks for foreign entries
    for (unsigned int k = 0; k < rows.size(); ++k)
      rhs.begin()[k] = residual[rows[k].entry];
    if (is_large())
      parts.solve(solution, rhs);
    else
      check(factorization.solve(solution, rhs));
    for (unsigned int k = 0; k < rows.size(); ++k)
      x[rows[k].entry] = solution.begin()[k];
  }
} // namespace stickslip
