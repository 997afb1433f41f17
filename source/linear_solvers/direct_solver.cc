#include <stickslip/linear_solvers/direct_solver.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Relative residual of a solve above which the matrix counts as singular.
    constexpr double singular_residual = 1e-6;

    const std::string name = "Linear solver (MUMPS)";

    const std::string singular_text = "the matrix is singular";



    /// In the plane a bisection takes longer than the factorisation that it is
    /// for (measured, doc/theory.md).
    DistributedFactorization::Ordering
    best_ordering(const unsigned int n_components)
    {
      using Ordering = DistributedFactorization::Ordering;
      return n_components < 3 ? Ordering::minimum_fill : Ordering::automatic;
    }
  } // namespace



  types::global_dof_index
  DirectSolver::MergedNumbering::operator()(
    const unsigned int            block,
    const types::global_dof_index i) const
  {
    const auto &starts = block_starts[block];
    const auto  rank =
      std::upper_bound(starts.begin(), starts.end(), i) - starts.begin() - 1;
    return merged_starts[block][rank] + (i - starts[rank]);
  }



  void
  DirectSolver::number_rows(const LA::BlockSparseMatrix &matrix)
  {
    const MPI_Comm     communicator = matrix.block(0, 0).get_mpi_communicator();
    const unsigned int n_blocks     = matrix.n_block_rows();
    numbering                       = MergedNumbering();
    types::global_dof_index              n_local = 0;
    std::vector<types::global_dof_index> sizes;
    for (unsigned int b = 0; b < n_blocks; ++b)
      {
        sizes.push_back(
          matrix.block(b, b).locally_owned_range_indices().n_elements());
        n_local += sizes.back();
      }
    const auto all_sizes = Utilities::MPI::all_gather(communicator, sizes);
    numbering.block_starts.resize(n_blocks);
    numbering.merged_starts.resize(n_blocks);
    std::vector<types::global_dof_index> in_block(n_blocks, 0);
    types::global_dof_index              merged_start = 0;
    for (const auto &rank_sizes : all_sizes)
      for (unsigned int b = 0; b < n_blocks; ++b)
        {
          numbering.block_starts[b].push_back(in_block[b]);
          numbering.merged_starts[b].push_back(merged_start);
          in_block[b] += rank_sizes[b];
          merged_start += rank_sizes[b];
        }
  }



  template <typename Visitor>
  void
  DirectSolver::visit_rows(const LA::BlockSparseMatrix &matrix,
                           const Visitor               &visit) const
  {
    std::vector<types::global_dof_index> columns;
    std::vector<double>                  values;
    for (unsigned int b = 0; b < matrix.n_block_rows(); ++b)
      for (const auto i : matrix.block(b, b).locally_owned_range_indices())
        {
          columns.clear();
          values.clear();
          for (unsigned int c = 0; c < matrix.n_block_cols(); ++c)
            if (matrix.block(b, c).n() > 0)
              LA::visit_row(matrix.block(b, c),
                            i,
                            [&](const auto column, const double value) {
                              columns.push_back(numbering(c, column));
                              values.push_back(value);
                            });
          visit(numbering(b, i), columns, values);
        }
  }



  void
  DirectSolver::make_pattern(const LA::BlockSparseMatrix &matrix)
  {
    const MPI_Comm communicator   = matrix.block(0, 0).get_mpi_communicator();
    types::global_dof_index total = 0, n_local = 0;
    for (unsigned int b = 0; b < matrix.n_block_rows(); ++b)
      {
        total += matrix.block(b, b).m();
        n_local +=
          matrix.block(b, b).locally_owned_range_indices().n_elements();
      }
    const types::global_dof_index start =
      numbering
        .merged_starts[0][Utilities::MPI::this_mpi_process(communicator)];
    IndexSet owned(total);
    owned.add_range(start, start + n_local);

    unsigned int longest = 0;
    for (unsigned int b = 0; b < matrix.n_block_rows(); ++b)
      {
        unsigned int length = 0;
        for (unsigned int c = 0; c < matrix.n_block_cols(); ++c)
          length += LA::longest_row(matrix.block(b, c));
        longest = std::max(longest, length);
      }
    LA::SparsityPattern pattern(owned, owned, communicator, longest);
    visit_rows(matrix, [&](const auto row, const auto &columns, const auto &) {
      pattern.add_entries(row, columns.begin(), columns.end());
    });
    pattern.compress();
    merged.reinit(pattern);
  }



  void
  DirectSolver::fill(const LA::BlockSparseMatrix &matrix)
  {
    visit_rows(matrix,
               [&](const auto row, const auto &columns, const auto &values) {
                 merged.set(row, columns, values, false);
               });
    merged.compress(VectorOperation::insert);
  }



  void
  DirectSolver::setup(const LA::BlockSparseMatrix &matrix,
                      const SystemDescriber       &describe)
  {
    const BlockSystemDescription &description = describe();
    const bool new_pattern = merged.m() == 0 || description.layout != layout;
    if (new_pattern)
      {
        layout = description.layout;
        factorization.clear();
        number_rows(matrix);
        make_pattern(matrix);
      }
    fill(matrix);
    if (!new_pattern && !factorization.refactorise())
      return;
    throw_if_failed(
      factorization.factorise(merged, best_ordering(description.n_components)),
      name,
      singular_text);
  }



  LinearSolve
  DirectSolver::solve(LA::BlockVector       &x,
                      const LA::BlockVector &b,
                      const double /*sufficient*/)
  {
    const IndexSet owned        = merged.locally_owned_range_indices();
    const MPI_Comm communicator = merged.get_mpi_communicator();
    LA::Vector     rhs(owned, communicator), solution(rhs), correction(rhs),
      residual(rhs);
    const auto for_each_entry = [&](const auto &visit) {
      for (unsigned int block = 0; block < b.n_blocks(); ++block)
        for (const auto i : b.block(block).locally_owned_elements())
          visit(block, i, numbering(block, i));
    };
    for_each_entry([&](const unsigned int block, const auto i, const auto j) {
      rhs(j) = b.block(block)(i);
    });
    rhs.compress(VectorOperation::insert);

    // A second solve with the residual restores the digits that pivoting for
    // sparsity gives away.
    const double scale = rhs.l2_norm();
    residual           = rhs;
    double error       = scale > 0. ? 1. : 0.;
    for (unsigned int pass = 0; pass < 3 && scale > 0.; ++pass)
      {
        throw_if_failed(factorization.solve(correction, residual),
                        name,
                        singular_text);
        solution += correction;
        merged.residual(residual, solution, rhs);
        const double new_error = residual.l2_norm() / scale;
        const bool   stagnates = !(new_error < 0.1 * error);
        error                  = new_error;
        if (error < 1e-15 || (pass > 0 && stagnates))
          break;
      }
    if (!(error < singular_residual))
      throw NoConvergence(name, singular_text, FailureCause::singular);

    for_each_entry([&](const unsigned int block, const auto i, const auto j) {
      x.block(block)(i) = solution(j);
    });
    x.compress(VectorOperation::insert);
    LinearSolve result;
    result.iterations = 1;
    return result;
  }
} // namespace stickslip
