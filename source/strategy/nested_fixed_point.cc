#include <stickslip/strategy/nested_fixed_point.h>

#include <stickslip/base/no_convergence.h>

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
    std::string failure;
    if (!solve_level(0, 0., x, failure))
      throw NoConvergence("Fixed point", failure, FailureCause::loop_limit);
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



  bool
  NestedFixedPoint::solve_inside(const unsigned int level,
                                 const double       accuracy,
                                 LA::BlockVector   &x,
                                 std::string       &failure,
                                 unsigned int      &n_failures) const
  {
    try
      {
        const bool converged = solve_level(level + 1, accuracy, x, failure);
        n_failures           = 0;
        return converged;
      }
    catch (const NoConvergence &inner)
      {
        // a loop limit that is thrown is that of the whole step
        if (inner.cause == FailureCause::loop_limit ||
            ++n_failures > loops[level].n_failures_outlived)
          throw;
        failure = inner.what();
        return false;
      }
  }



  bool
  NestedFixedPoint::solve_level(const unsigned int level,
                                const double       accuracy,
                                LA::BlockVector   &x,
                                std::string       &failure) const
  {
    if (level == loops.size())
      {
        solve_inner(x);
        return true;
      }
    const FixedPointLoop &loop = loops[level];
    if (loop.is_live)
      return solve_level(level + 1, accuracy, x, failure);
    const double tolerance =
      loop.is_relative ? std::max(loop.tolerance, accuracy) : loop.tolerance;

    loop.quantity->evaluate(x);
    loop.quantity->accept();
    double                  change          = 1.;
    bool                    inner_converged = false;
    std::set<std::uint64_t> seen;
    bool                    is_repetition = false;
    const auto              see           = [&]() {
      const std::uint64_t fingerprint = loop.quantity->fingerprint();
      return fingerprint != 0 && !seen.insert(fingerprint).second;
    };
    see();

    FixedPointAcceleration acceleration;
    LA::BlockVector        start;
    unsigned int           pass       = 1;
    unsigned int           n_failures = 0; ///< of the inner solver, in a row
    for (; pass <= loop.max_iterations && !is_repetition; ++pass)
      {
        // An inner loop may run into its limit while this one is still far from
        // its fixed point (the first statuses cycle); only the last pass
        // counts.
        start = x;
        const double inner_accuracy =
          loop.is_relative ? accuracy_inside(level, change) : accuracy;
        inner_converged =
          solve_inside(level, inner_accuracy, x, failure, n_failures);
        loop.quantity->evaluate(x);
        change = loop.quantity->change();
        loop.quantity->accept();
        ++*loop.n_loops;
        report(loop.quantity->name(), pass, change, level);
        if (inner_converged && change <= tolerance &&
            inner_accuracy <= accuracy)
          return true;
        is_repetition = see();
        if (!loop.is_accelerated)
          continue;
        if (!inner_converged)
          acceleration.clear();
        else
          {
            acceleration.improve(start, x);
            loop.quantity->evaluate(x);
            loop.quantity->accept();
          }
      }
    std::ostringstream text;
    text << "the " << loop.quantity->name() << " loop "
         << (is_repetition ? "repeats itself after " : "did not settle in ")
         << pass - 1 << " passes; last change " << change << " (tolerance "
         << tolerance << ")";
    if (!inner_converged)
      text << "; inside its last pass: " << failure;
    failure = text.str();
    return false;
  }
} // namespace stickslip
