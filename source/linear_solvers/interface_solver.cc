#include <stickslip/linear_solvers/interface_solver.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstddef>
#include <string>

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
                      const double number = numbers[c](column);
                      if (number > 0.)
                        visit(static_cast<types::global_dof_index>(number -
                                                                   0.5),
                              value);
                    });
  }



  void
  InterfaceSolver::number_rows(const LA::BlockSparseMatrix &matrix)
  {
    const MPI_Comm communicator = matrix.block(0, 0).get_mpi_communicator();
    rows.clear();
    unsigned int entry = 0;
    for (const auto i : matrix.block(0, 0).locally_owned_range_indices())
      {
        if (LA::row_length(matrix.block(0, 1), i) > 0)
          rows.push_back({0, i, entry});
        ++entry;
      }
    for (const auto i : matrix.block(1, 1).locally_owned_range_indices())
      rows.push_back({1, i, entry++});
    const types::global_dof_index n_owned = rows.size();
    first                                 = 0;
    const int error                       = MPI_Exscan(
      &n_owned, &first, 1, DEAL_II_DOF_INDEX_MPI_TYPE, MPI_SUM, communicator);
    AssertThrowMPI(error);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      first = 0; // MPI leaves it undefined there

    // tell the other ranks the numbers of the columns that they see
    for (unsigned int block = 0; block < 2; ++block)
      {
        const IndexSet owned =
          matrix.block(block, block).locally_owned_range_indices();
        std::vector<types::global_dof_index> seen;
        for (const Row &row : rows)
          LA::visit_row(matrix.block(row.block, block),
                        row.index,
                        [&](const auto column, const double) {
                          if (!owned.is_element(column))
                            seen.push_back(column);
                        });
        std::sort(seen.begin(), seen.end());
        IndexSet needed = owned;
        needed.add_indices(seen.begin(), std::unique(seen.begin(), seen.end()));
        LA::Vector mine(owned, communicator);
        for (unsigned int k = 0; k < rows.size(); ++k)
          if (rows[k].block == block)
            mine(rows[k].index) = first + k + 1.;
        mine.compress(VectorOperation::insert);
        numbers[block].reinit(owned, needed, communicator);
        numbers[block] = mine;
      }
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
    rhs.reinit(owned, communicator);
    solution.reinit(owned, communicator);
  }



  void
  InterfaceSolver::fill(const LA::BlockSparseMatrix &matrix)
  {
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



  void
  InterfaceSolver::factorise(const LA::BlockSparseMatrix &matrix,
                             const bool                   new_layout)
  {
    factorization.clear();
    parts.clear();
    if (new_layout)
      {
        number_rows(matrix);
        make_pattern(matrix);
      }
    fill(matrix);
    if (!is_large())
      {
        check(factorization.factorise(interface));
        return;
      }
    std::vector<bool> is_multiplier;
    for (const Row &row : rows)
      is_multiplier.push_back(row.block == 1);
    check(parts.factorise(interface, is_multiplier, new_layout));
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
