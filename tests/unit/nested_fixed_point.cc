// Two nested fixed-point loops of numbers: how exactly the inner one is solved
// and what the outer one makes of an inner solver that fails.

#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/nested_fixed_point.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  /// A number that is frozen, and the one that the solution has.
  class Number : public FreezableQuantity
  {
  public:
    Number(const std::string &name, const unsigned int entry)
      : label(name)
      , entry(entry)
    {}

    std::string
    name() const override
    {
      return label;
    }

    void
    set_live(const bool) override
    {}

    void
    evaluate(const LA::BlockVector &x) override
    {
      evaluated = x.block(0)(entry);
    }

    double
    change() const override
    {
      return std::abs(evaluated - frozen);
    }

    void
    accept() override
    {
      frozen = evaluated;
    }

    double frozen = 0.;

  private:
    const std::string  label;
    const unsigned int entry;
    double             evaluated = 0.;
  };
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Number                           outer("outer", 0), inner("inner", 1);
  unsigned int                     n_outer = 0, n_inner = 0;

  FixedPointLoop outer_loop;
  outer_loop.quantity       = &outer;
  outer_loop.is_live        = false;
  outer_loop.tolerance      = 1e-6;
  outer_loop.max_iterations = 50;
  outer_loop.n_loops        = &n_outer;
  FixedPointLoop inner_loop = outer_loop;
  inner_loop.quantity       = &inner;
  inner_loop.n_loops        = &n_inner;

  // x0 = 1 + x1 / 10, x1 = 1 - x1 / 4 + x0 / 5
  const auto solve = [&](LA::BlockVector &x) {
    x.block(0)(0) = 1. + 0.1 * inner.frozen;
    x.block(0)(1) = 1. - 0.25 * inner.frozen + 0.2 * outer.frozen;
    x.compress(VectorOperation::insert);
  };
  const auto report = [](const std::string &name,
                         const unsigned int pass,
                         const double       change,
                         const unsigned int depth) {
    std::cout << std::string(2 * depth + 2, ' ') << name << " pass " << pass
              << ": change " << change << '\n';
  };

  IndexSet        entries = complete_index_set(2);
  LA::BlockVector x({entries}, MPI_COMM_SELF);
  std::cout << "An inner loop stops at a tenth of the outer change:\n";
  NestedFixedPoint({outer_loop, inner_loop}, solve, report).solve(x);
  std::cout << n_outer << " outer, " << n_inner << " inner passes\n";
  const double error =
    std::max(std::abs(x.block(0)(0) - 1. - 0.1 * x.block(0)(1)),
             std::abs(1.25 * x.block(0)(1) - 1. - 0.2 * x.block(0)(0)));
  std::cout << (error < 3e-6 ? "both equations hold\n" : "wrong\n");

  std::cout << "A count has no accuracy to share:\n";
  n_inner = n_outer      = 0;
  x                      = 0.;
  inner_loop.is_relative = false;
  NestedFixedPoint({outer_loop, inner_loop}, solve, [](auto &&...) {}).solve(x);
  std::cout << n_outer << " outer, " << n_inner << " inner passes\n";
}
