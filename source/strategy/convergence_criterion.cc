#include <stickslip/strategy/convergence_criterion.h>

#include <stickslip/strategy/residual_monitors.h>

#include <algorithm>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// A full step with a relative increment up to this leaves a residual of
    /// roundoff.
    constexpr double roundoff_increment = 1e-13;

    /// A relative increment up to which one that is still to come is not worth
    /// an iteration.
    constexpr double negligible_increment = 1e-10;

    /// Unknowns that have fallen to this fraction of the largest they have been
    /// are roundoff.
    constexpr double roundoff_of_unknowns = 1e-13;



    double
    relative_to(const double tolerance, const double residual)
    {
      return residual / std::max(tolerance, std::numeric_limits<double>::min());
    }
    /// What the increment after @p state is expected to be: smaller than the
    /// last one by the factor by which that has reduced the residual. While
    /// displacements are being prescribed the residual before is that of
    /// another problem, and reactions and face sizes are what it is measured
    /// by.
    double
    expected_increment(const NewtonIteration &before,
                       const NewtonIteration &state)
    {
      const double residual_before =
        before.prescribed > 0. ? 1. : residual_size(before);
      return state.increment * residual_size(state) /
             std::max(residual_before, std::numeric_limits<double>::min());
    }
  } // namespace



  ConvergenceCriterion::ConvergenceCriterion(const NewtonParameters &parameters)
    : equilibrium_tolerance(parameters.equilibrium_tolerance)
    , contact_tolerance(parameters.contact_tolerance)
    , increment_tolerance(parameters.increment_tolerance)
  {}



  bool
  ConvergenceCriterion::is_met(const unsigned int     iteration,
                               const NewtonIteration &before,
                               const NewtonIteration &state) const
  {
    const bool is_full_step = iteration > 0 && state.step_length == 1.;
    const bool is_roundoff =
      is_full_step && state.increment <= roundoff_increment;
    const double allowance = is_roundoff ? roundoff_allowance : 1.;
    const bool   has_settled =
      iteration == 0 || state.increment <= increment_tolerance ||
      (is_full_step &&
       expected_increment(before, state) <= negligible_increment);
    return state.prescribed == 0. &&
           state.equilibrium <= allowance * equilibrium_tolerance &&
           state.contact <= contact_tolerance && has_settled;
  }



  double
  ConvergenceCriterion::excess(const NewtonIteration &state) const
  {
    return std::max(relative_to(equilibrium_tolerance, state.equilibrium),
                    relative_to(contact_tolerance, state.contact));
  }



  IncrementNorm::IncrementNorm(const NewtonProblem   &problem,
                               const LA::BlockVector &start)
  {
    for (unsigned int b = 0; b < start.n_blocks(); ++b)
      {
        largest.push_back(
          start.block(b).size() > 0 ? start.block(b).linfty_norm() : 0.);
        negligible.push_back(problem.negligible_unknown(b));
      }
  }



  double
  IncrementNorm::relative_increment(const LA::BlockVector &x,
                                    const LA::BlockVector &increment)
  {
    double result = 0.;
    for (unsigned int b = 0; b < x.n_blocks(); ++b)
      if (x.block(b).size() > 0)
        {
          const double size = x.block(b).linfty_norm();
          largest[b]        = std::max(largest[b], size);
          const double roundoff =
            std::max(negligible[b], roundoff_of_unknowns * largest[b]);
          if (largest[b] > 0.)
            result = std::max(result,
                              increment.block(b).linfty_norm() /
                                std::max(size, roundoff));
        }
    return result;
  }
} // namespace stickslip
