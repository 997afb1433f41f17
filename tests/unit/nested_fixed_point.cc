// Fixed-point loops over numbers whose fixed points and contractions are known:
// the number of passes, the accuracy of inner loops, and what is made of
// failures inside.

#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/nested_fixed_point.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  void
  print(const std::string &text, const bool holds)
  {
    std::cout << "  " << text << ": " << (holds ? "yes" : "NO") << '\n';
  }



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

    std::uint64_t
    fingerprint() const override
    {
      return is_discrete ? std::uint64_t(std::lround(frozen)) + 1000 : 0;
    }

    double frozen      = 0.;
    bool   is_discrete = false;

  private:
    const std::string  label;
    const unsigned int entry;
    double             evaluated = 0.;
  };



  FixedPointLoop
  make_loop(Number &number, unsigned int &n_loops)
  {
    n_loops = 0;
    FixedPointLoop loop;
    loop.quantity       = &number;
    loop.is_live        = false;
    loop.tolerance      = 1e-6;
    loop.max_iterations = 50;
    loop.n_loops        = &n_loops;
    return loop;
  }



  void
  no_report(const std::string &,
            const unsigned int,
            const double,
            const unsigned int)
  {}



  LA::BlockVector
  zero()
  {
    const IndexSet entries = complete_index_set(2);
    return LA::BlockVector({entries}, MPI_COMM_SELF);
  }



  /// Sets x to these entries.
  void
  set(LA::BlockVector &x, const double x0, const double x1)
  {
    x.block(0)(0) = x0;
    x.block(0)(1) = x1;
    x.compress(VectorOperation::insert);
  }



  /// The failure that @p loops end with, in words.
  std::string
  failure_of(const std::vector<FixedPointLoop>   &loops,
             const NestedFixedPoint::InnerSolver &solve_inner)
  {
    LA::BlockVector x = zero();
    try
      {
        NestedFixedPoint(loops, solve_inner, no_report).solve(x);
      }
    catch (const NoConvergence &failure)
      {
        return to_string(failure.cause) + ", loop '" + failure.place.loop + "'";
      }
    return "none";
  }



  void
  test_contraction()
  {
    std::cout << "x = 1 + c q, q = x:\n";
    for (const double c : {0.5, -0.25, 0.9})
      {
        Number          number("quantity", 0);
        unsigned int    n    = 0;
        FixedPointLoop  loop = make_loop(number, n);
        LA::BlockVector x    = zero();
        loop.max_iterations  = 200;
        NestedFixedPoint(
          {loop},
          [&](LA::BlockVector &x) { set(x, 1. + c * number.frozen, 0.); },
          no_report)
          .solve(x);
        // pass k changes q by |c|^(k-1)
        const auto expected = static_cast<unsigned int>(
          1 + std::ceil(std::log(1e-6) / std::log(std::abs(c))));
        std::cout << "  c = " << c << ": " << n << " passes\n";
        print("the number that the contraction makes", n == expected);
        print("the fixed point 1 / (1 - c) within c / (1 - c) of the tolerance",
              std::abs(x.block(0)(0) - 1. / (1. - c)) <=
                1.001e-6 * std::abs(c / (1. - c)));
      }
  }



  void
  test_nesting()
  {
    std::cout << "x0 = 1 + q1 / 10, x1 = 1 - q1 / 4 + q0 / 5:\n";
    Number         outer("outer", 0), inner("inner", 1);
    unsigned int   n_outer = 0, n_inner = 0, n_strict = 0;
    FixedPointLoop outer_loop = make_loop(outer, n_outer);
    FixedPointLoop inner_loop = make_loop(inner, n_inner);
    const auto     solve      = [&](LA::BlockVector &x) {
      set(x,
          1. + 0.1 * inner.frozen,
          1. - 0.25 * inner.frozen + 0.2 * outer.frozen);
    };
    // An inner loop stops at a tenth of the last outer change, while that is
    // above the tolerance.
    bool            is_accurate = true;
    double          last_inner = 1., last_outer = 1.;
    LA::BlockVector x = zero();
    NestedFixedPoint({outer_loop, inner_loop},
                     solve,
                     [&](const std::string &,
                         const unsigned int,
                         const double       change,
                         const unsigned int depth) {
                       if (depth == 1)
                         last_inner = change;
                       else
                         {
                           is_accurate =
                             is_accurate &&
                             last_inner <= std::max(0.1 * last_outer, 1e-6);
                           last_outer = change;
                         }
                     })
      .solve(x);
    print("inner loops are as accurate as an outer pass can use", is_accurate);
    // x1 = (1 + q0 / 5) / 1.25 and x0 = 1 + x1 / 10
    const double x0 = (1. + 0.08) / (1. - 0.016);
    print("the fixed point",
          std::abs(x.block(0)(0) - x0) < 1e-6 &&
            std::abs(x.block(0)(1) - 10. * (x0 - 1.)) < 1e-5);
    x                      = zero();
    inner_loop.is_relative = false;
    inner_loop.n_loops     = &n_strict;
    outer.frozen = inner.frozen = 0.;
    NestedFixedPoint({outer_loop, inner_loop}, solve, no_report).solve(x);
    print("a loop that counts is always solved exactly, in more passes",
          n_strict > n_inner);
    outer_loop.is_live = true;
    n_outer            = 0;
    x                  = zero();
    NestedFixedPoint({outer_loop, inner_loop}, solve, no_report).solve(x);
    print("a live quantity has no loop", n_outer == 0);
  }



  void
  test_failures_of_loops()
  {
    std::cout << "Loops that do not settle:\n";
    Number         number("geometry", 0);
    unsigned int   n    = 0;
    FixedPointLoop loop = make_loop(number, n);
    const auto     grow = [&](LA::BlockVector &x) {
      set(x, 1. + 1.1 * number.frozen, 0.);
    };
    std::cout << "  x = 1 + 1.1 q: " << failure_of({loop}, grow) << '\n';
    print("after all its passes", n == 50);

    Number         status("status", 0);
    FixedPointLoop discrete = make_loop(status, n);
    status.is_discrete      = true;
    discrete.is_relative    = false;
    const auto alternate    = [&](LA::BlockVector &x) {
      set(x, 1. - status.frozen, 0.);
    };
    std::cout << "  x = 1 - q: " << failure_of({discrete}, alternate) << '\n';
    print("as soon as 0 is frozen again", n == 2);

    unsigned int   n_outer = 0;
    Number         settled("threshold", 1);
    FixedPointLoop outer = make_loop(settled, n_outer);
    outer.max_iterations = 4;
    std::cout << "  the same inside a loop that has settled: "
              << failure_of({outer, discrete}, alternate) << '\n';
    print("which hopes until its last pass", n_outer == 4);
  }



  void
  test_failures_inside()
  {
    std::cout << "An inner solver that fails in its first three calls:\n";
    for (const unsigned int n_outlived : {0, 2, 3})
      for (const FailureCause cause :
           {FailureCause::stagnation, FailureCause::budget})
        {
          Number         number("threshold", 0);
          unsigned int   n = 0, n_calls = 0;
          FixedPointLoop loop      = make_loop(number, n);
          loop.n_failures_outlived = n_outlived;
          const auto solve         = [&](LA::BlockVector &x) {
            if (++n_calls <= 3)
              throw NoConvergence("inner", "planted", cause);
            set(x, 1. + 0.5 * number.frozen, 0.);
          };
          const std::string failure = failure_of({loop}, solve);
          std::cout << "  " << to_string(cause) << ", " << n_outlived
                    << " outlived: failure " << failure << " after " << n_calls
                    << " calls\n";
        }
    std::cout << "One that fails in every third call:\n";
    Number         number("threshold", 0);
    unsigned int   n = 0, n_calls = 0;
    FixedPointLoop loop       = make_loop(number, n);
    loop.n_failures_outlived  = 1;
    const std::string failure = failure_of({loop}, [&](LA::BlockVector &x) {
      if (++n_calls % 3 == 0)
        throw NoConvergence("inner", "planted", FailureCause::cycle);
      set(x, 1. + 0.5 * number.frozen, 0.);
    });
    print("never two in a row: the loop settles", failure == "none");
    std::cout << "One that fails in the last pass:\n";
    loop                     = make_loop(number, n);
    loop.n_failures_outlived = 100;
    loop.max_iterations      = 5;
    number.frozen            = 0.;
    std::cout << "  " << failure_of({loop}, [](LA::BlockVector &) {
      throw NoConvergence("inner", "planted", FailureCause::cycle);
    }) << '\n';
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_contraction();
  test_nesting();
  test_failures_of_loops();
  test_failures_inside();
}
