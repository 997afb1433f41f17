#ifndef stickslip_strategy_solution_strategy_h
#define stickslip_strategy_solution_strategy_h

#include <stickslip/base/solve_counts.h>

#include <stickslip/strategy/nested_fixed_point.h>
#include <stickslip/strategy/newton_parameters.h>

#include <array>
#include <string>
#include <vector>

namespace stickslip
{
  /// What an algorithm does with one of the three contact quantities.
  struct LoopParameters
  {
    std::string  treatment;
    double       tolerance      = 1e-6;
    unsigned int max_iterations = 20;
    std::string  acceleration   = "none";

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
    std::string      name    = "automatic";
    std::string      tangent = "consistent";
    LoopParameters   geometry{"newton", 1e-6, 30, "Anderson"};
    LoopParameters   threshold{"newton", 1e-6, 50, "Anderson"};
    LoopParameters   status{"newton", 0., 20, "none"};
    NewtonParameters newton;

    void
    add_parameters(ParameterHandler &prm);
  };



  /**
   * The one place that knows the algorithms by name: turns the name into the
   * live/frozen decisions of the three quantities (paper, section 3).
   *
   * | name   | geometry    | threshold   | status      |
   * |--------|-------------|-------------|-------------|
   * | FPM    | fixed point | fixed point | fixed point |
   * | PNM    | fixed point | newton      | newton      |
   * | GNM    | newton      | newton      | newton      |
   * | GCP    | fixed point | fixed point | projected conjugate gradient |
   * | custom | as the parameters say                   |
   *
   * @p name is one of these; `automatic` is not (see AlgorithmLadder).
   */
  std::vector<FixedPointLoop>
  make_loops(const std::string                        &name,
             const AlgorithmParameters                &parameters,
             const std::array<FreezableQuantity *, 3> &quantities,
             SolveCounts                              &counts);
} // namespace stickslip

#endif
