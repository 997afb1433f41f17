#include <stickslip/base/no_convergence.h>

#include <stickslip/strategy/fixed_point_acceleration.h>
#include <stickslip/strategy/nested_fixed_point.h>

#include <set>
#include <sstream>

namespace stickslip
{
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
    if (!solve_level(0, x, failure))
      throw NoConvergence("Fixed point", failure, FailureCause::loop_limit);
  }



  bool
  NestedFixedPoint::solve_inside(const unsigned int level,
                                 LA::BlockVector   &x,
                                 std::string       &failure,
                                 unsigned int      &n_failures) const
  {
    try
      {
        const bool converged = solve_level(level + 1, x, failure);
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
      return solve_level(level + 1, x, failure);

    loop.quantity->evaluate(x);
    loop.quantity->accept();
    double                  change          = 0.;
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
        start           = x;
        inner_converged = solve_inside(level, x, failure, n_failures);
        loop.quantity->evaluate(x);
        change = loop.quantity->change();
        loop.quantity->accept();
        ++*loop.n_loops;
        report(loop.quantity->name(), pass, change, level);
        if (inner_converged && change <= loop.tolerance)
          return true;
        is_repetition = see();
        if (!loop.is_accelerated)
          continue;
        // The first pass has also applied prescribed displacements.
        if (!inner_converged || pass == 1)
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
         << loop.tolerance << ")";
    if (!inner_converged)
      text << "; inside its last pass: " << failure;
    failure = text.str();
    return false;
  }
} // namespace stickslip
