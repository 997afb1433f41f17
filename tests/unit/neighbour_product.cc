// Products in which a rank waits for its neighbours only, against those of the
// matrix itself; several at a time, and block by block.

#include "print.h"

#include <stickslip/linear_solvers/block_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace stickslip;

namespace
{
  IndexSet
  owned_part(const unsigned int size)
  {
    const unsigned int n_ranks =
                         Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                       rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    IndexSet owned(size);
    owned.add_range(size * rank / n_ranks, size * (rank + 1) / n_ranks);
    return owned;
  }



  /// A few entries in each third row, near the diagonal and far from it, so
  /// that not all columns are needed, owned ones neither.
  LA::SparseMatrix
  sparse_matrix(const unsigned int n_rows,
                const unsigned int n_columns,
                const unsigned int every)
  {
    const IndexSet rows = owned_part(n_rows), columns = owned_part(n_columns);
    LA::SparsityPattern pattern(rows, columns, MPI_COMM_WORLD, 5);
    const auto          visit = [&](const auto &function) {
      for (const auto i : rows)
        if (n_columns > 0 && i % every == 0)
          for (const auto j : {i, i + 1, 3 * i + 2, 7 * i + 5, 11 * i})
            function(i, j % n_columns);
    };
    visit([&](const auto i, const auto j) { pattern.add(i, j); });
    pattern.compress();
    LA::SparseMatrix matrix;
    matrix.reinit(pattern);
    visit([&](const auto i, const auto j) {
      matrix.add(i, j, std::sin(1. + 3. * i + 5. * j));
    });
    matrix.compress(VectorOperation::add);
    return matrix;
  }



  LA::Vector
  vector(const unsigned int size)
  {
    LA::Vector x(owned_part(size), MPI_COMM_WORLD);
    for (const auto i : x.locally_owned_elements())
      x(i) = std::cos(2. + 7. * i);
    x.compress(VectorOperation::insert);
    return x;
  }



  void
  test_matrix(const unsigned int n_rows,
              const unsigned int n_columns,
              const unsigned int every)
  {
    const LA::SparseMatrix A = sparse_matrix(n_rows, n_columns, every);
    const LA::Vector       x = vector(n_columns), z = vector(n_rows);
    LA::Vector             expected(z), y(z), expected_t(x), y_t(x);
    A.vmult_add(expected, x);
    A.Tvmult_add(expected_t, z);
    NeighbourProduct product, another;
    product.reinit(A);
    another.reinit(A);
    // two on their way at a time
    std::vector<double> doubled(x.begin(), x.end()), rest(z.begin(), z.end());
    for (double &value : doubled)
      value *= 2.;
    product.start(x.begin());
    another.start(doubled.data());
    product.finish_add(y.begin(), x.begin());
    another.finish_add(rest.data(), doubled.data());
    product.add_transposed(y_t.begin(), z.begin());
    double error = 0.;
    for (unsigned int i = 0; i < rest.size(); ++i)
      error =
        std::max(error,
                 std::abs(rest[i] - 2. * expected.begin()[i] + z.begin()[i]));
    y -= expected;
    y_t -= expected_t;
    print(std::to_string(n_rows) + " x " + std::to_string(n_columns));
    print("  product", y.linfty_norm() < 1e-13);
    print("  a second one at the same time",
          Utilities::MPI::max(error, MPI_COMM_WORLD) < 1e-13);
    print("  transposed product", y_t.linfty_norm() < 1e-13);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_matrix(200, 200, 1);
  test_matrix(200, 30, 3);
  test_matrix(30, 200, 2);
  test_matrix(200, 0, 1);
}
