// What libraries report when they factorise: the meaning of their codes, and
// matrices that provoke them. The same on any number of ranks; the libraries'
// own texts would appear in the output.

#include "print.h"

#include <stickslip/base/no_convergence.h>

#include <stickslip/linear_solvers/factorization/distributed_factorization.h>
#include <stickslip/linear_solvers/factorization/local_factorization.h>
#include <stickslip/linear_solvers/factorization/root_factorization.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  std::string
  name_of(const FactorizationError::Kind kind)
  {
    switch (kind)
      {
        case FactorizationError::Kind::none:
          return "none";
        case FactorizationError::Kind::singular:
          return "singular";
        case FactorizationError::Kind::workspace:
          return "workspace";
        case FactorizationError::Kind::out_of_memory:
          return "out of memory";
        case FactorizationError::Kind::other:
          return "other";
      }
    return "";
  }



  void
  print_error(const FactorizationError &error)
  {
    print("  " + name_of(error.kind) + ": " + describe(error));
  }



  void
  test_meanings()
  {
    print("MUMPS");
    for (const auto &[code, detail] :
         std::vector<std::pair<int, int>>{{0, 0},
                                          {2, 0}, // a warning
                                          {-6, 7},
                                          {-10, 7},
                                          {-8, 1056},
                                          {-9, 1056},
                                          {-9, -3},
                                          {-17, 20},
                                          {-20, 20},
                                          {-13, 500},
                                          {-13, -5000},
                                          {-19, 0},
                                          {-7, 100},
                                          {-16, -1},
                                          {-99, 5}})
      print_error(mumps_error(code, detail));
    print("UMFPACK");
    for (const int status : {0, 1, -1, -8})
      print_error(umfpack_error(status));
  }



  void
  test_causes()
  {
    print("Causes");
    for (const auto &error : {mumps_error(-10, 3), mumps_error(-9, 3)})
      try
        {
          throw_if_failed(error, "Solver", "a body is free");
        }
      catch (const NoConvergence &failure)
        {
          print("  " + to_string(failure.cause) + ": " + failure.what());
        }
    throw_if_failed(FactorizationError(), "Solver", "a body is free");

    // one rank is out of memory, others have no error, or a singular part
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    print_error(worst_of(rank == 0       ? umfpack_error(-1)
                         : rank % 2 == 0 ? umfpack_error(1)
                                         : FactorizationError(),
                         MPI_COMM_WORLD));
  }



  /// Which row of a matrix is changed, and how.
  enum class Defect
  {
    none,
    zero_row,
    equal_rows
  };



  /// Springs between the nodes of an n x n grid, and ties between pairs of
  /// nodes: rows without diagonal entries, as those of multipliers.
  struct TiedGrid
  {
    TiedGrid(const unsigned int n, const Defect defect)
    {
      const unsigned int n_ranks =
                           Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                         rank =
                           Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n_nodes = n * n, size = n_nodes + n_nodes / 3;
      owned.set_size(size);
      owned.add_range(size * rank / n_ranks, size * (rank + 1) / n_ranks);
      LA::SparsityPattern pattern(owned, owned, MPI_COMM_WORLD, 12);
      const auto          visit_entries = [&](const auto &visit) {
        const auto add = [&](const auto i, const auto j, const double value) {
          const bool is_zero = defect == Defect::zero_row && i == n_nodes / 2;
          if (owned.is_element(i))
            visit(i, j, is_zero ? 0. : value);
          // row 1 repeats row 0
          if (defect == Defect::equal_rows && i == 0 && owned.is_element(1))
            visit(1, j, value);
        };
        for (unsigned int i = 0; i < n_nodes; ++i)
          if (defect != Defect::equal_rows || i != 1)
            {
              add(i, i, 1e-6);
              if ((i + 1) % n > 0)
                add(i, i + 1, -1. - 0.3 * std::sin(i));
              if (i + n < n_nodes)
                add(i, i + n, -1. - 0.3 * std::cos(i));
              if (i % n > 0)
                add(i, i - 1, 1.);
              if (i >= n)
                add(i, i - n, -1.);
            }
        for (unsigned int k = 0; k < n_nodes / 3; ++k)
          for (const unsigned int node : {3 * k, (17 * k + 5) % n_nodes})
            {
              add(n_nodes + k, node, node == 3 * k ? 1. : -0.9);
              if (defect != Defect::equal_rows || node != 1)
                add(node, n_nodes + k, node == 3 * k ? 1. : -0.8);
            }
      };
      visit_entries(
        [&](const auto i, const auto j, const double) { pattern.add(i, j); });
      pattern.compress();
      matrix.reinit(pattern);
      visit_entries([&](const auto i, const auto j, const double value) {
        matrix.add(i, j, value);
      });
      matrix.compress(VectorOperation::add);
      b.reinit(owned, MPI_COMM_WORLD);
      for (const auto i : owned)
        b(i) = std::sin(1. + 7. * i);
      b.compress(VectorOperation::insert);
    }

    /// |A x - b| / |b|
    double
    residual(const LA::Vector &x) const
    {
      LA::Vector rest(b);
      matrix.vmult(rest, x);
      rest -= b;
      return rest.l2_norm() / b.l2_norm();
    }

    /// Multiplies each entry by factor(row, column).
    template <typename Factor>
    void
    scale(const Factor &factor)
    {
      for (const auto i : owned)
        {
          std::vector<types::global_dof_index> columns;
          std::vector<double>                  values;
          LA::visit_row(matrix, i, [&](const auto column, const double value) {
            columns.push_back(column);
            values.push_back(value * factor(i, column));
          });
          matrix.set(i, columns, values, false);
        }
      matrix.compress(VectorOperation::insert);
    }

    IndexSet         owned;
    LA::SparseMatrix matrix;
    LA::Vector       b;
  };



  void
  test_mumps()
  {
    print("MUMPS with matrices");
    for (const Defect defect :
         {Defect::none, Defect::zero_row, Defect::equal_rows})
      {
        const TiedGrid           grid(12, defect);
        DistributedFactorization factorization;
        const FactorizationError error = factorization.factorise(grid.matrix);
        print("  " + name_of(error.kind));
        if (error)
          continue;
        LA::Vector x(grid.b);
        print("  solves", !factorization.solve(x, grid.b));
        print("  residual below 1e-9", grid.residual(x) < 1e-9);
      }
  }



  /// Newton's iterations have matrices of one pattern: the order of the first
  /// one serves the others, whatever pivots they need, and after a singular
  /// one.
  void
  test_new_values()
  {
    print("MUMPS with other values in the same pattern");
    TiedGrid                 grid(12, Defect::none);
    DistributedFactorization factorization;
    print("  without factors: " + name_of(factorization.refactorise().kind));
    const auto solve = [&]() {
      LA::Vector x(grid.b);
      print("  solves", !factorization.solve(x, grid.b));
      print("  residual below 1e-9", grid.residual(x) < 1e-9);
    };
    print_error(factorization.factorise(
      grid.matrix, DistributedFactorization::Ordering::minimum_fill));
    solve();
    grid.scale([](const auto i, const auto j) {
      return i == j ? 0. : 1. + 0.9 * std::sin(5. * i + 3. * j);
    });
    print_error(factorization.refactorise());
    solve();
    const TiedGrid singular(12, Defect::zero_row), regular(12, Defect::none);
    grid.matrix.copy_from(singular.matrix);
    print("  " + name_of(factorization.refactorise().kind));
    grid.matrix.copy_from(regular.matrix);
    print_error(factorization.refactorise());
    solve();
  }



  /// The same matrices, on rank 0.
  void
  test_root()
  {
    print("UMFPACK with distributed matrices");
    for (const Defect defect :
         {Defect::none, Defect::zero_row, Defect::equal_rows})
      {
        const TiedGrid                      grid(12, defect);
        std::vector<RootFactorization::Row> rows;
        for (const auto i : grid.owned)
          {
            rows.emplace_back();
            LA::visit_row(grid.matrix,
                          i,
                          [&](const auto column, const double value) {
                            rows.back().columns.push_back(column);
                            rows.back().values.push_back(value);
                          });
          }
        RootFactorization        factorization;
        const FactorizationError error =
          factorization.factorise(rows, MPI_COMM_WORLD);
        print("  " + name_of(error.kind));
        const std::vector<double> b(grid.b.begin(), grid.b.end());
        std::vector<double>       entries;
        factorization.solve(entries, b);
        LA::Vector x(grid.b);
        std::copy(entries.begin(), entries.end(), x.begin());
        if (error)
          print("  no solution that looks like one",
                !std::isfinite(x.l2_norm()));
        else
          print("  residual below 1e-9", grid.residual(x) < 1e-9);
      }
  }



  /// Pivoting needs more than MUMPS estimates; with as much as there is not in
  /// any computer it runs out of memory.
  void
  test_workspace()
  {
    print("Workspace of MUMPS");
    const TiedGrid           grid(40, Defect::none);
    DistributedFactorization factorization(0);
    print_error(factorization.factorise(grid.matrix));
    const int supplement = factorization.workspace_supplement();
    print("  more than the usual supplement",
          supplement > DistributedFactorization::usual_supplement);
    LA::Vector x(grid.b);
    print("  solves", !factorization.solve(x, grid.b));
    print("  residual below 1e-9", grid.residual(x) < 1e-9);
    print_error(factorization.factorise(grid.matrix));
    print("  enough at once the next time",
          factorization.workspace_supplement() == supplement);
    DistributedFactorization insatiable(100000000);
    const FactorizationError error = insatiable.factorise(grid.matrix);
    print("  " + name_of(error.kind) +
          ", INFOG(1) = " + std::to_string(error.code));
    print("  more than 1e9 numbers", error.amount > 1000000000);
  }



  void
  test_local()
  {
    print("UMFPACK with matrices");
    LocalFactorization factorization;
    print_error(factorization.factorise({0, 2, 4}, {0, 1, 0, 1}, {0, 2, 1, 1}));
    std::vector<double> x;
    print("  solves", !factorization.solve(x, {2., 3.}));
    print("  the solution",
          std::abs(x[0] - 2.) < 1e-14 && std::abs(x[1] - 1.) < 1e-14);
    print_error(factorization.factorise({0, 2, 4}, {0, 1, 0, 1}, {1, 2, 2, 4}));
    print_error(factorization.factorise({0, 0, 0}, {}, {}));
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_meanings();
  test_causes();
  test_mumps();
  test_new_values();
  test_root();
  test_workspace();
  test_local();
}
