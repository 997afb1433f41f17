// When 'automatic' takes MUMPS instead of the iteration: after three slow
// solves in a row, for systems up to 50,000 unknowns, for 10, 20, ... systems.

#include <stickslip/linear_solvers/automatic_solver.h>

#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// Solves with the given numbers of iterations (0: without convergence), and
  /// how many systems MUMPS solves after each.
  void
  show(const std::string               &what,
       const std::vector<unsigned int> &iterations,
       const unsigned int               size)
  {
    SlowIteration slow;
    std::cout << what << ", " << size << " unknowns:";
    for (const unsigned int n : iterations)
      {
        slow.record(n, size, n > 0);
        unsigned int n_direct = 0;
        while (slow.prefers_direct(size))
          ++n_direct;
        std::cout << ' ' << n;
        if (n_direct > 0)
          std::cout << " (then " << n_direct << " direct)";
      }
    std::cout << '\n';
  }
} // namespace

int
main()
{
  show("fast", {20, 25, 30, 20}, 25000);
  show("at the limit", {60, 60, 60, 60}, 25000);
  show("slow", {61, 61, 61}, 25000);
  show("slow now and then", {80, 80, 20, 80, 80, 20}, 25000);
  show("slow for a while", {80, 80, 80, 20, 80, 80, 20}, 25000);
  show("slow always", {80, 80, 80, 80, 80, 80, 80, 80, 80}, 25000);
  show("failing", {0, 0, 0, 0, 20}, 25000);
  show("smaller", {60, 60, 60}, 12500);
  show("largest", {121, 121, 121}, 50000);
  show("too large", {200, 200, 200}, 50001);
}
