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
  DirectSolver::number_rows(const LA::BlockSparseMatrix &matrix,
                            const MPI_Comm              &communicator)
  {
    const unsigned int n_blocks                  = matrix.n_block_rows();
    numbering                                    = MergedNumbering();
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



  void
  DirectSolver::copy_blocks(const LA::BlockSparseMatrix &matrix,
                            const MPI_Comm              &communicator)
  {
    const unsigned int n_blocks = matrix.n_block_rows();
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    types::global_dof_index total = 0, n_local = 0;
    for (unsigned int b = 0; b < n_blocks; ++b)
      {
        total += matrix.block(b, b).m();
        n_local +=
          matrix.block(b, b).locally_owned_range_indices().n_elements();
      }
    const types::global_dof_index start = numbering.merged_starts[0][rank];
    IndexSet                      owned(total);
    owned.add_range(start, start + n_local);

    std::vector<std::vector<types::global_dof_index>> columns(n_local);
    std::vector<std::vector<double>>                  values(n_local);
    std::size_t                                       longest = 0;
    for (unsigned int b = 0; b < n_blocks; ++b)
      for (const auto i : matrix.block(b, b).locally_owned_range_indices())
        {
          const auto row = numbering(b, i) - start;
          for (unsigned int c = 0; c < n_blocks; ++c)
            if (matrix.block(b, c).n() > 0)
              LA::visit_row(matrix.block(b, c),
                            i,
                            [&](const auto column, const double value) {
                              columns[row].push_back(numbering(c, column));
                              values[row].push_back(value);
                            });
          longest = std::max(longest, columns[row].size());
        }
    LA::SparsityPattern pattern(owned, owned, communicator, longest);
    for (types::global_dof_index row = 0; row < n_local; ++row)
      pattern.add_entries(start + row,
                          columns[row].begin(),
                          columns[row].end());
    pattern.compress();
    merged.reinit(pattern);
    for (types::global_dof_index row = 0; row < n_local; ++row)
      merged.set(start + row, columns[row], values[row], false);
    merged.compress(VectorOperation::insert);
  }



  void
  DirectSolver::setup(const LA::BlockSparseMatrix &matrix,
                      const SystemDescriber &)
  {
    const MPI_Comm communicator = matrix.block(0, 0).get_mpi_communicator();
    number_rows(matrix, communicator);
    factorization.clear();
    copy_blocks(matrix, communicator);
    throw_if_failed(factorization.factorise(merged), name, singular_text);
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
