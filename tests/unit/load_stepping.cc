// Sizes of load steps and limits of their Newton iterations: cuts, growth with
// patience after them, and steps that cost more than two halves would.

#include <stickslip/simulation/load_stepping.h>

#include <iostream>
#include <limits>

using namespace stickslip;

namespace
{
  /// Proposes a step; it is accepted if it is at most @p largest, with these
  /// iterations.
  void
  step(LoadStepping      &stepping,
       const double       largest,
       const unsigned int iterations)
  {
    const double       size = stepping.propose_step() - stepping.time();
    const unsigned int most = stepping.iteration_limit();
    std::cout << "  " << size;
    if (most < std::numeric_limits<unsigned int>::max())
      std::cout << " (at most " << most << " iterations)";
    if (size > largest)
      {
        stepping.cut_step(NoConvergence("test", "", FailureCause::stagnation));
        std::cout << ": cut\n";
        return;
      }
    stepping.accept_step(iterations);
    std::cout << ": " << iterations << " iterations\n";
  }
} // namespace



int
main()
{
  LoadSteppingParameters parameters;
  parameters.end_time      = 1000.;
  parameters.initial_step  = 1.;
  parameters.minimum_step  = 0.1;
  parameters.growth_factor = 1.5;

  std::cout << "Steps above 0.7 fail:\n";
  LoadStepping stepping(parameters);
  step(stepping, 1., 5);
  for (unsigned int i = 0; i < 25; ++i)
    step(stepping, 0.7, 6);
  std::cout << "They do no more, but some are not easy:\n";
  for (unsigned int i = 0; i < 20; ++i)
    step(stepping, 1., i == 2 ? 50 : 7);

  std::cout << "No limit where a cut is not possible:\n";
  parameters.minimum_step = 0.6;
  LoadStepping coarse(parameters);
  for (unsigned int i = 0; i < 3; ++i)
    step(coarse, 1., 200);
}
