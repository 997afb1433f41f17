// Which algorithm is tried when, and how long what has helped is kept.

#include <stickslip/strategy/algorithm_ladder.h>

#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  /// A step that @p sufficient and what comes after it solve.
  void
  step(AlgorithmLadder &ladder, const std::string &sufficient)
  {
    const std::string order = "GNM PNM FPM";
    ladder.begin_step();
    std::cout << ladder.algorithm();
    while (order.find(ladder.algorithm()) < order.find(sufficient))
      {
        if (!ladder.climb(NoConvergence("test", "", FailureCause::stagnation)))
          {
            std::cout << ", cut\n";
            return;
          }
        std::cout << " -> " << ladder.algorithm();
      }
    ladder.accept_step();
    std::cout << '\n';
  }
} // namespace



int
main()
{
  std::cout << "A named algorithm is the only one:\n";
  AlgorithmLadder named("PNM");
  step(named, "PNM");
  step(named, "FPM");

  std::cout << "automatic; PNM once, which stays for a step:\n";
  AlgorithmLadder ladder("automatic");
  step(ladder, "GNM");
  step(ladder, "PNM");
  for (unsigned int i = 0; i < 2; ++i)
    step(ladder, "GNM");
  std::cout << "Needed time and again it stays longer:\n";
  for (unsigned int i = 0; i < 12; ++i)
    step(ladder, "PNM");
  std::cout << "To the top, and down one by one:\n";
  step(ladder, "FPM");
  for (unsigned int i = 0; i < 30; ++i)
    step(ladder, "GNM");
  std::cout << "Nothing helps:\n";
  step(ladder, "none of them");

  std::cout << "Causes that another algorithm may mend:\n";
  for (const FailureCause cause : {FailureCause::cycle,
                                   FailureCause::stagnation,
                                   FailureCause::loop_limit,
                                   FailureCause::divergence,
                                   FailureCause::inadmissible,
                                   FailureCause::singular,
                                   FailureCause::linear_solver,
                                   FailureCause::rejected})
    {
      AlgorithmLadder fresh("automatic");
      fresh.begin_step();
      std::cout << "  " << to_string(cause) << ": "
                << (fresh.climb(NoConvergence("test", "", cause)) ? "yes"
                                                                  : "no")
                << '\n';
    }
}
