#include <stickslip/strategy/convergence_criterion.h>

#include <algorithm>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// A full step with a relative increment up to this leaves a residual of
    /// roundoff.
    constexpr double roundoff_increment = 1e-13;

    /// How far above its tolerance such a residual may be, as a factor.
    constexpr double roundoff_allowance = 100.;

    /// Unknowns that have fallen to this fraction of the largest they have been
    /// are roundoff.
    constexpr double roundoff_of_unknowns = 1e-13;



    double
    relative_to(const double tolerance, const double residual)
    {
      return residual / std::max(tolerance, std::numeric_limits<double>::min());
    }
  } // namespace



  ConvergenceCriterion::ConvergenceCriterion(const NewtonParameters &parameters)
    : equilibrium_tolerance(parameters.equilibrium_tolerance)
    , contact_tolerance(parameters.contact_tolerance)
    , increment_tolerance(parameters.increment_tolerance)
  {}



  bool
  ConvergenceCriterion::is_met(const unsigned int     iteration,
                               const NewtonIteration &state) const
  {
    const bool is_roundoff = iteration > 0 && state.step_length == 1. &&
                             state.increment <= roundoff_increment;
    const double allowance = is_roundoff ? roundoff_allowance : 1.;
    return state.prescribed == 0. &&
           state.equilibrium <= allowance * equilibrium_tolerance &&
           state.contact <= contact_tolerance &&
           (iteration == 0 || state.increment <= increment_tolerance);
  }



  double
  ConvergenceCriterion::excess(const NewtonIteration &state) const
  {
    return std::max(relative_to(equilibrium_tolerance, state.equilibrium),
                    relative_to(contact_tolerance, state.contact));
  }



  IncrementNorm::IncrementNorm(const LA::BlockVector &start)
  {
    for (unsigned int b = 0; b < start.n_blocks(); ++b)
      largest.push_back(start.block(b).size() > 0 ? start.block(b).linfty_norm()
                                                  : 0.);
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
          if (largest[b] > 0.)
            result =
              std::max(result,
                       increment.block(b).linfty_norm() /
                         std::max(size, roundoff_of_unknowns * largest[b]));
        }
    return result;
  }
} // namespace stickslip
