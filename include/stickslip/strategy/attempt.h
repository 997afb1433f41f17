#ifndef stickslip_strategy_attempt_h
#define stickslip_strategy_attempt_h

#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/solution_strategy.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  /// How the next attempt at a load step is made: all that is chosen about it.
  struct Attempt
  {
    /// The state that Newton starts from.
    enum class Guess
    {
      accepted, ///< the last accepted state
      predicted ///< that state, with its displacements extrapolated
    };

    /// The regularization parameters r of the contact points.
    enum class Scales
    {
      as_adapted, ///< with the factors of earlier cycle treatments
      automatic   ///< set back to what the rule has by itself
    };

    /// How contact points find their master facets.
    enum class Pairing
    {
      memoryless, ///< from the present positions only
      hysteresis  ///< points that switch facets often keep theirs a little
                  ///< beyond its edge
    };

    Algorithm    algorithm = Algorithm::automatic;
    Guess        guess     = Guess::accepted;
    Scales       scales    = Scales::as_adapted;
    Pairing      pairing   = Pairing::memoryless;
    unsigned int budget    = std::numeric_limits<unsigned int>::max();
    ///< Newton iterations after which the attempt has failed

    /// False: if all attempts fail, the run ends.
    bool step_can_be_cut = true;
  };



  /// Whether an attempt with another treatment of the contact points would
  /// differ from the one that has just failed.
  struct RetryEffect
  {
    bool scales  = false; ///< some r is not at the stiffness of the contact
    bool pairing = false; ///< some points switch facets without hysteresis
  };



  /**
   * The attempt that follows on @p failed, which ended because of @p cause;
   * none: the step has to be cut.
   *
   * 1. Once per algorithm: a retry from the same guess with scales at the
   *    contact stiffness and pairing hysteresis, if that changes anything
   *    (@p effect).
   * 2. The next algorithm of @p sequence, from the accepted state, where the
   *    cause is one that another algorithm may remove: unknown statuses,
   *    thresholds and pairings. Bodies that nothing supports need another case;
   *    a step that is too large for the bodies is better cut, and only where it
   *    cannot be cut any more the other algorithms are tried.
   */
  std::optional<Attempt>
  next_attempt(const Attempt                &failed,
               const FailureCause            cause,
               const RetryEffect            &effect,
               const std::vector<Algorithm> &sequence);

  /// For the log: what distinguishes @p next from the attempt @p failed.
  std::string
  describe_change(const Attempt &failed, const Attempt &next);
} // namespace stickslip

#endif
