// Which algorithm is tried when, and how long what has helped is kept.

#include <stickslip/strategy/algorithm_ladder.h>

#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  /// A step that only @p works solves, up to which the ladder is climbed.
  void
  step(AlgorithmLadder &ladder, const std::string &works)
  {
    ladder.begin_step();
    std::cout << ladder.algorithm();
    while (ladder.algorithm() != works)
      {
        if (!ladder.climb(NoConvergence("test", "", FailureCause::stagnation)))
          {
            std::cout << " none";
            break;
          }
        std::cout << " -> " << ladder.algorithm();
      }
    if (ladder.algorithm() == works)
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

  std::cout << "automatic:\n";
  AlgorithmLadder ladder("automatic");
  step(ladder, "GNM");
  step(ladder, "PNM");
  std::cout << "GNM would do again; PNM stays for a step:\n";
  for (unsigned int i = 0; i < 3; ++i)
    step(ladder, i == 0 ? "PNM" : "GNM");
  std::cout << "The second time it stays for two:\n";
  step(ladder, "PNM");
  for (unsigned int i = 0; i < 4; ++i)
    step(ladder, i < 2 ? "PNM" : "GNM");
  std::cout << "To the top, down one by one, and nothing:\n";
  step(ladder, "FPM");
  step(ladder, "FPM");
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
