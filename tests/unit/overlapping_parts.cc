// Overlapping parts of a saddle point matrix: two membranes of n x n nodes, of
// which multipliers hold the upper one by ties to the lower one, as contact
// does. One part is an exact solve; several make a preconditioner, also if all
// ties were open in the matrix before.

#include "print.h"

#include <stickslip/linear_solvers/overlapping_parts.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>
#include <vector>

using namespace stickslip;

namespace
{
  constexpr unsigned int n = 12;



  /// Nodes of the lower and of the upper membrane, then multipliers: ranks
  /// have parts of all three.
  struct TiedMembranes
  {
    explicit TiedMembranes(const bool is_closed)
      : is_closed(is_closed)
    {
      const unsigned int n_ranks =
                           Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                         rank =
                           Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int size = 2 * n * n + n, begin = size * rank / n_ranks,
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
          is_multiplier.push_back(row >= 2 * n * n);
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
    const bool is_closed;

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
      for (unsigned int node = 0; node < 2 * n * n; ++node)
        {
          const bool is_upper = node >= n * n;
          add(node, node, is_upper && is_closed ? 0. : 0.01);
          if ((node + 1) % n > 0)
            add_spring(node, node + 1);
          if (node + n < (is_upper ? 2 : 1) * n * n)
            add_spring(node, node + n);
        }
      // the last row of nodes of the lower one, the first of the upper one
      for (unsigned int k = 0; k < n; ++k)
        {
          const unsigned int multiplier = 2 * n * n + k, upper = n * n + k;
          add(multiplier, multiplier, is_closed ? 0. : -1.);
          for (const unsigned int end : {upper, upper - n})
            {
              const double sign = is_closed ? (end == upper ? 1. : -1.) : 0.;
              add(multiplier, end, sign);
              add(end, multiplier, 1.2 * sign); // not symmetric
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
    const TiedMembranes open(false), closed(true);
    OverlappingParts    parts(largest);
    for (const bool is_first : {true, false})
      {
        const TiedMembranes     &tied = is_first ? open : closed;
        const FactorizationError error =
          parts.factorise(tied.matrix, tied.is_multiplier);
        AssertThrow(!error, ExcInternalError());
      }
    LA::Vector x(closed.b);
    x = 0.;
    bool is_fast;
    if (most_iterations == 1) // of which versions of GMRES make two
      {
        parts.solve(x, closed.b);
        is_fast = closed.residual(x) < 1e-9;
      }
    else
      {
        SolverControl            control(100, 1e-10 * closed.b.l2_norm());
        SolverFGMRES<LA::Vector> solver(control);
        solver.solve(closed.matrix, x, closed.b, Preconditioner{parts});
        is_fast = control.last_step() <= most_iterations;
      }
    print("parts of " + std::to_string(largest) + ": at most " +
            std::to_string(most_iterations) + " iterations",
          is_fast);
    print("the solution", closed.residual(x) < 1e-9);
  }



  /// A part of one rank only is singular.
  void
  test_singular()
  {
    TiedMembranes membranes(true);
    for (const auto row : membranes.owned)
      if (row == 0)
        membranes.matrix.clear_row(row, 0.);
    membranes.matrix.compress(VectorOperation::insert);
    OverlappingParts         parts(40);
    const FactorizationError error =
      parts.factorise(membranes.matrix, membranes.is_multiplier);
    print("a row of zeros is noticed on all ranks",
          error.kind == FactorizationError::Kind::singular);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // one part on one rank is exact
  const bool is_alone = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  test(2 * n * n + n, is_alone ? 1 : 30);
  test(80, 30);
  test(20, 60);
  test_singular();
}
