// An algorithm: a quantity that may be frozen, and the loop around it. The
// manual shows these functions (doc/developers.md).

#include <stickslip/strategy/nested_fixed_point.h>
#include <stickslip/strategy/solution_strategy.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  // [quantity]
  /// A friction coefficient that rises with the pressure p: mu = 0.2 + p/10.
  /// Live, a residual uses `evaluated`; frozen, it uses `frozen`.
  class FrictionCoefficient : public FreezableQuantity
  {
  public:
    std::string
    name() const override
    {
      return "friction coefficient";
    }

    void
    set_live(const bool live) override
    {
      is_live = live;
    }

    void
    evaluate(const LA::BlockVector &x) override
    {
      evaluated = 0.2 + 0.1 * x.block(0)(0);
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

    double
    value() const
    {
      return is_live ? evaluated : frozen;
    }

  private:
    bool   is_live   = true;
    double evaluated = 0.2, frozen = 0.2;
  };
  // [end of quantity]



  void
  set_pressure(LA::BlockVector &x, const double pressure)
  {
    x.block(0)(0) = pressure;
    x.compress(VectorOperation::insert);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  LA::BlockVector                  x({complete_index_set(1)}, MPI_COMM_SELF);

  // [loop]
  // A wedge: p = 2 - mu p. Frozen, the inner solver sees a number.
  FrictionCoefficient mu;
  mu.set_live(false);
  unsigned int   n_passes = 0;
  FixedPointLoop loop;
  loop.quantity       = &mu;
  loop.is_live        = false;
  loop.tolerance      = 1e-8;
  loop.max_iterations = 50;
  loop.n_loops        = &n_passes;
  NestedFixedPoint(
    {loop},
    [&](LA::BlockVector &x) { set_pressure(x, 2. / (1. + mu.value())); },
    [](const std::string &, unsigned int, double, unsigned int) {})
    .solve(x);
  // [end of loop]

  // 0.1 p^2 + 1.2 p - 2 = 0
  const double expected = -6. + std::sqrt(36. + 20.);
  std::cout << "p is that of the live equation: "
            << (std::abs(x.block(0)(0) - expected) < 1e-7 ? "yes" : "NO")
            << "\npasses of the loop: " << n_passes << '\n';

  // The names that users know are rows of one table.
  const SolutionStrategy pnm =
    strategy_of(Algorithm::pnm, AlgorithmParameters());
  std::cout << name_of(Algorithm::pnm) << " freezes";
  const char *names[] = {"geometry", "threshold", "status"};
  for (unsigned int i = 0; i < 3; ++i)
    if (pnm.treatments[i] == Treatment::fixed_point)
      std::cout << ' ' << names[i];
  std::cout << '\n';
}
