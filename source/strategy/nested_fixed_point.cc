#include <stickslip/strategy/nested_fixed_point.h>

#include <stickslip/strategy/fixed_point_acceleration.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Relative to the last change of a loop, the change at which the loops
    /// inside it may stop: more exact, they would only follow a value that is
    /// about to be replaced.
    constexpr double useful_accuracy = 0.1;



    /// What a loop that did not converge leaves behind.
    NoConvergence
    failure_of(const FixedPointLoop               &loop,
               const unsigned int                  n_passes,
               const double                        change,
               const double                        tolerance,
               const bool                          is_repetition,
               const std::optional<NoConvergence> &inside)
    {
      std::ostringstream text;
      text << "the " << loop.quantity->name() << " loop "
           << (is_repetition ? "repeats itself after " : "did not settle in ")
           << n_passes << " passes; last change " << change << " (tolerance "
           << tolerance << ")";
      if (inside)
        text << "; inside its last pass: "
             << (inside->place.loop.empty() ? inside->what() : inside->reason);
      FailurePlace place;
      place.loop = loop.quantity->name();
      return NoConvergence("Fixed point",
                           text.str(),
                           is_repetition ? FailureCause::loop_cycle
                                         : FailureCause::loop_limit,
                           place);
    }
  } // namespace



  NestedFixedPoint::NestedFixedPoint(std::vector<FixedPointLoop> loops,
                                     InnerSolver                 solve_inner,
                                     Report                      report)
    : loops(std::move(loops))
    , solve_inner(std::move(solve_inner))
    , report(std::move(report))
  {}



  void
  NestedFixedPoint::solve(LA::BlockVector &x) const
  {
    for (const FixedPointLoop &loop : loops)
      loop.quantity->set_live(loop.is_live);
    if (const auto failure = solve_level(0, 0., x))
      throw *failure;
  }



  double
  NestedFixedPoint::accuracy_inside(const unsigned int level,
                                    const double       change) const
  {
    if (change <= loops[level].tolerance)
      return 0.;
    double finest = std::numeric_limits<double>::max();
    for (unsigned int i = level + 1; i < loops.size(); ++i)
      if (loops[i].is_relative && !loops[i].is_live)
        finest = std::min(finest, loops[i].tolerance);
    const double accuracy = useful_accuracy * change;
    return accuracy > finest ? accuracy : 0.;
  }



  std::optional<NoConvergence>
  NestedFixedPoint::solve_inside(const unsigned int level,
                                 const double       accuracy,
                                 LA::BlockVector   &x,
                                 unsigned int      &n_failures) const
  {
    try
      {
        auto failure = solve_level(level + 1, accuracy, x);
        n_failures   = 0;
        return failure;
      }
    catch (const NoConvergence &failure)
      {
        if (failure.cause == FailureCause::budget ||
            failure.cause == FailureCause::linear_solver ||
            ++n_failures > loops[level].n_failures_outlived)
          throw;
        return failure;
      }
  }



  std::optional<NoConvergence>
  NestedFixedPoint::solve_level(const unsigned int level,
                                const double       accuracy,
                                LA::BlockVector   &x) const
  {
    if (level == loops.size())
      {
        solve_inner(x);
        return {};
      }
    const FixedPointLoop &loop = loops[level];
    if (loop.is_live)
      return solve_level(level + 1, accuracy, x);
    const double tolerance =
      loop.is_relative ? std::max(loop.tolerance, accuracy) : loop.tolerance;

    loop.quantity->evaluate(x);
    loop.quantity->accept();
    std::set<std::uint64_t> values; ///< all that were frozen so far
    const auto              is_frozen_again = [&]() {
      const std::uint64_t value = loop.quantity->fingerprint();
      return value != 0 && !values.insert(value).second;
    };
    bool is_repetition = is_frozen_again();

    FixedPointAcceleration acceleration;
    LA::BlockVector        start;
    double                 change     = 1.;
    unsigned int           n_passes   = 0;
    unsigned int           n_failures = 0; ///< of the inner solver, in a row
    std::optional<NoConvergence> inside;
    while (n_passes < loop.max_iterations && !is_repetition)
      {
        // An inner loop may run into its limit while this one is still far from
        // its fixed point (the first statuses cycle); only the last pass
        // counts.
        start = x;
        const double inner_accuracy =
          loop.is_relative ? accuracy_inside(level, change) : accuracy;
        inside.reset();
        if (const auto failure =
              solve_inside(level, inner_accuracy, x, n_failures))
          inside.emplace(*failure);
        ++n_passes;
        loop.quantity->evaluate(x);
        change = loop.quantity->change();
        loop.quantity->accept();
        ++*loop.n_loops;
        report(loop.quantity->name(), n_passes, change, level);
        if (!inside && change <= tolerance && inner_accuracy <= accuracy)
          return {};
        is_repetition = is_frozen_again();
        if (!loop.is_accelerated)
          continue;
        if (inside)
          acceleration.clear();
        else
          {
            acceleration.improve(start, x);
            loop.quantity->evaluate(x);
            loop.quantity->accept();
          }
      }
    return failure_of(loop, n_passes, change, tolerance, is_repetition, inside);
  }
} // namespace stickslip
