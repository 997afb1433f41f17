// When 'automatic' gives up the iteration: after three slow solves in a row,
// for systems up to 50,000 unknowns.

#include <stickslip/linear_solvers/automatic_solver.h>

#include <iostream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  void
  show(const std::string               &what,
       const std::vector<unsigned int> &iterations,
       const unsigned int               size)
  {
    SlowIteration slow;
    std::cout << what << ", " << size << " unknowns:";
    for (const unsigned int n : iterations)
      {
        slow.record(n, size);
        std::cout << ' ' << n
                  << (slow.prefers_direct(size) ? " direct" : " iterative");
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
  show("slow once and for all", {80, 80, 80, 20}, 25000);
  show("smaller", {60, 60, 60}, 12500);
  show("largest", {121, 121, 121}, 50000);
  show("too large", {200, 200, 200}, 50001);
}
