#ifndef stickslip_strategy_algorithm_ladder_h
#define stickslip_strategy_algorithm_ladder_h

#include <stickslip/base/no_convergence.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Which algorithm to try in a load step, and which after it. A named
   * algorithm is the only rung of its ladder; `automatic` climbs from GNM to
   * PNM and FPM where a solve fails in a way that another algorithm can mend:
   * cycles, stagnation, rejected states. Smaller steps mend the rest. A rung
   * that had to be climbed is where the next steps begin, for longer each time;
   * then the one below is tried again.
   */
  class AlgorithmLadder
  {
  public:
    /// @p name as in 'Algorithm/Name'.
    explicit AlgorithmLadder(const std::string &name);

    /// Another attempt at a step begins.
    void
    begin_step();

    /// The algorithm to use.
    const std::string &
    algorithm() const
    {
      return rungs[rung];
    }

    /// True if it makes sense to try algorithm(), now the next one, on the same
    /// step.
    bool
    climb(const NoConvergence &failure);

    /// The step was solved by algorithm().
    void
    accept_step();

    /// True if there is anything to choose.
    bool
    has_choice() const
    {
      return rungs.size() > 1;
    }

  private:
    const std::vector<std::string> rungs;
    unsigned int                   rung       = 0;
    unsigned int                   first_rung = 0; ///< of the next step
    unsigned int n_stay = 0; ///< steps to stay on first_rung before descending
    unsigned int patience = 1; ///< what n_stay becomes after the next climb
  };
} // namespace stickslip

#endif
