#ifndef stickslip_strategy_solution_strategy_h
#define stickslip_strategy_solution_strategy_h

#include <stickslip/base/choice.h>
#include <stickslip/base/solve_counts.h>

#include <stickslip/strategy/nested_fixed_point.h>
#include <stickslip/strategy/newton_parameters.h>

#include <array>
#include <string>
#include <vector>

namespace stickslip
{
  /// 'Algorithm/Name'. What each of them does is in solution_strategy.cc; no
  /// other file compares these values.
  enum class Algorithm
  {
    automatic,
    fpm,
    pnm,
    gnm,
    gcp,
    custom
  };

  const Choices<Algorithm> &
  all_algorithms();

  const std::string &
  name_of(const Algorithm algorithm);



  /// What an algorithm does with one of the three contact quantities.
  enum class Treatment
  {
    newton,     ///< live: recomputed in every residual, linearized
    fixed_point ///< frozen during Newton, refreshed in a loop
  };

  /// How a fixed-point loop finds the start of its next pass.
  enum class Acceleration
  {
    anderson,
    none
  };

  enum class Tangent
  {
    consistent,
    quasi ///< without the second variations
  };

  /// What finds the increment of a Newton iteration.
  enum class IncrementSolver
  {
    linear_system,
    projected_conjugate_gradient ///< with the inequalities of contact
  };



  /// One of the subsections 'Algorithm/Geometry', 'Threshold', 'Status'.
  struct LoopParameters
  {
    Treatment    treatment      = Treatment::newton;
    double       tolerance      = 1e-6;
    unsigned int max_iterations = 20;
    Acceleration acceleration   = Acceleration::none;

    void
    add_parameters(ParameterHandler  &prm,
                   const std::string &what,
                   const std::string &change);

    /// For loops over continuous quantities.
    void
    add_acceleration(ParameterHandler &prm);
  };



  /// The section "Algorithm".
  struct AlgorithmParameters
  {
    Algorithm        name    = Algorithm::automatic;
    Tangent          tangent = Tangent::consistent;
    LoopParameters   geometry{Treatment::newton,
                            1e-6,
                            30,
                            Acceleration::anderson};
    LoopParameters   threshold{Treatment::newton,
                             1e-6,
                             50,
                             Acceleration::anderson};
    LoopParameters   status{Treatment::newton, 0., 20, Acceleration::none};
    NewtonParameters newton;

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError for treatments that the algorithm would not use.
    void
    check(const std::string &path) const;
  };



  /**
   * The decisions that an algorithm stands for (paper, section 3):
   *
   * | name   | geometry    | threshold   | status      |
   * |--------|-------------|-------------|-------------|
   * | FPM    | fixed point | fixed point | fixed point |
   * | PNM    | fixed point | newton      | newton      |
   * | GNM    | newton      | newton      | newton      |
   * | GCP    | fixed point | fixed point | projected conjugate gradient |
   * | custom | as the parameters say                   |
   */
  struct SolutionStrategy
  {
    std::array<Treatment, 3> treatments; ///< of geometry, threshold, status
    IncrementSolver          increment_solver = IncrementSolver::linear_system;
  };

  /// @p algorithm is one of a fallback sequence, never `automatic`.
  SolutionStrategy
  strategy_of(const Algorithm algorithm, const AlgorithmParameters &parameters);

  /// The loops of a strategy, geometry outermost.
  std::vector<FixedPointLoop>
  make_loops(const SolutionStrategy                   &strategy,
             const AlgorithmParameters                &parameters,
             const std::array<FreezableQuantity *, 3> &quantities,
             SolveCounts                              &counts);

  /**
   * The algorithms to try in a step, one after the other: a named one alone;
   * for `automatic` first the one with everything in Newton, then those with
   * fixed points, which settle where it cycles. Without contact
   * (@p has_contact) all are the same, and one is enough.
   */
  std::vector<Algorithm>
  fallback_sequence(const Algorithm chosen, const bool has_contact);

  /// True if @p algorithm treats every multiplier by itself, so that a contact
  /// point must not have more than one.
  bool
  needs_law_per_multiplier(const Algorithm algorithm);

  /// True if @p algorithm solves with the stiffness of the bodies alone, so that
  /// they have to be held without contact.
  bool
  needs_held_bodies(const Algorithm algorithm);



  // Advice to a user, as entries of a .prm.

  /// Where points switch between facets: the geometry frozen.
  std::string
  advice_to_freeze_geometry();

  /// Where statuses cycle: the algorithms of `automatic` after the first.
  std::string
  advice_to_fall_back();

  /// Where a fixed-point loop does not settle: no such loops.
  std::string
  advice_to_avoid_loops();
} // namespace stickslip

#endif
