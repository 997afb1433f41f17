// Overlapping parts of a saddle point matrix: a membrane of n x n nodes whose
// middle row of nodes is tied to the next one by multipliers. One part is an
// exact solve; several make a preconditioner, none of them singular, that finds
// the same solution.

#include "print.h"

#include <stickslip/linear_solvers/overlapping_parts.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>

using namespace stickslip;

namespace
{
  constexpr unsigned int n = 12;



  /// Displacements by rows of nodes, then multipliers; the ties are in the
  /// rows of the rank that has the last nodes.
  struct TiedMembrane
  {
    TiedMembrane()
    {
      const unsigned int n_ranks =
                           Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                         rank =
                           Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int size = n * n + n, begin = size * rank / n_ranks,
                         end = size * (rank + 1) / n_ranks;
      owned.set_size(size);
      owned.add_range(begin, end);
      LA::SparsityPattern pattern(owned, owned, MPI_COMM_WORLD, 8);
      visit_entries(
        [&](const auto i, const auto j, const double) { pattern.add(i, j); });
      pattern.compress();
      matrix.reinit(pattern);
      visit_entries([&](const auto i, const auto j, const double value) {
        matrix.add(i, j, value);
      });
      matrix.compress(VectorOperation::add);
      b.reinit(owned, MPI_COMM_WORLD);
      for (unsigned int row = begin; row < end; ++row)
        {
          is_multiplier.push_back(row >= n * n);
          b(row) = std::sin(1. + 7. * row);
        }
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

    IndexSet          owned;
    LA::SparseMatrix  matrix;
    LA::Vector        b;
    std::vector<bool> is_multiplier;

  private:
    template <typename Visitor>
    void
    visit_entries(const Visitor &visit) const
    {
      const auto add = [&](const auto i, const auto j, const double value) {
        if (owned.is_element(i))
          visit(i, j, value);
      };
      const auto add_spring = [&](const unsigned int i, const unsigned int j) {
        add(i, i, 1.);
        add(j, j, 1.);
        add(i, j, -1.);
        add(j, i, -1.);
      };
      for (unsigned int row = 0; row < n; ++row)
        for (unsigned int column = 0; column < n; ++column)
          {
            const unsigned int node = row * n + column;
            add(node, node, 0.01);
            if (column + 1 < n)
              add_spring(node, node + 1);
            if (row + 1 < n)
              add_spring(node, node + n);
          }
      for (unsigned int k = 0; k < n; ++k)
        {
          const unsigned int multiplier = n * n + k, node = n / 2 * n + k;
          for (const double sign : {1., -1.})
            {
              const unsigned int end = sign > 0. ? node : node + n;
              add(multiplier, end, sign);
              add(end, multiplier, sign);
            }
        }
    }
  };



  /// What SolverGMRES asks for.
  struct Preconditioner
  {
    const OverlappingParts &parts;

    void
    vmult(LA::Vector &x, const LA::Vector &b) const
    {
      parts.solve(x, b);
    }
  };



  void
  test(const unsigned int largest, const unsigned int most_iterations)
  {
    const TiedMembrane membrane;
    OverlappingParts   parts(largest);
    parts.factorise(membrane.matrix, membrane.is_multiplier, true);
    LA::Vector               x(membrane.b);
    SolverControl            control(100, 1e-10 * membrane.b.l2_norm());
    SolverFGMRES<LA::Vector> solver(control);
    x = 0.;
    solver.solve(membrane.matrix, x, membrane.b, Preconditioner{parts});
    print("parts of " + std::to_string(largest) + ": at most " +
            std::to_string(most_iterations) + " iterations",
          control.last_step() <= most_iterations);
    print("the solution", membrane.residual(x) < 1e-9);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one part on one rank is exact
  const bool is_alone = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  test(n * n + n, is_alone ? 1 : 30);
  test(40, 30);
  test(15, 30);
}
