#include <stickslip/strategy/fixed_point_acceleration.h>

#include <vector>

namespace stickslip
{
  namespace
  {
    /// Differences of passes that are kept. A loop has few slow directions, and
    /// old passes have seen other statuses and facets.
    constexpr unsigned int memory = 3;

    /// What is left of a difference without the newer ones, relatively, below
    /// which it says nothing new.
    constexpr double dependent = 1e-6;

    /// Largest correction over the residual of the pass: as for a contraction
    /// of 0.9. A slower one needs several passes; longer jumps rely on a slope
    /// near 1 that roundoff, or a status that has changed, may just pretend.
    constexpr double largest_correction = 10.;
  } // namespace



  void
  FixedPointAcceleration::clear()
  {
    differences.clear();
    last_residual.clear();
  }



  void
  FixedPointAcceleration::remember(const LA::Vector      &residual,
                                   const LA::BlockVector &result)
  {
    if (last_residual.size() > 0)
      {
        // Passes before a growth have been in another regime.
        if (residual.l2_norm() > last_residual.l2_norm())
          differences.clear();
        Difference difference{residual, result};
        difference.residual -= last_residual;
        difference.result -= last_result;
        differences.push_front(difference);
        if (differences.size() > memory)
          differences.pop_back();
      }
    last_residual = residual;
    last_result   = result;
  }



  void
  FixedPointAcceleration::improve(const LA::BlockVector &start,
                                  LA::BlockVector       &x)
  {
    LA::Vector residual(x.block(0));
    residual -= start.block(0);
    remember(residual, x);

    // Gram-Schmidt: each direction is orthogonal to those before it, and the
    // results undergo the same operations as the residuals.
    const double            allowed = largest_correction * residual.l2_norm();
    LA::BlockVector         improved(x);
    std::vector<Difference> basis;
    for (Difference direction : differences)
      {
        const double norm = direction.residual.l2_norm();
        for (const Difference &other : basis)
          {
            const double part = direction.residual * other.residual;
            direction.residual.add(-part, other.residual);
            direction.result.add(-part, other.result);
          }
        const double rest = direction.residual.l2_norm();
        if (rest <= dependent * norm)
          continue;
        direction.residual *= 1. / rest;
        direction.result *= 1. / rest;
        const double part = residual * direction.residual;
        residual.add(-part, direction.residual);
        improved.add(-part, direction.result);
        basis.push_back(direction);
      }
    improved -= x;
    const double length = improved.block(0).l2_norm();
    x.add(length > allowed ? allowed / length : 1., improved);
  }
} // namespace stickslip
