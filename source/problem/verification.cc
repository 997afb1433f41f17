#include <stickslip/problem/verification.h>

#include <stickslip/base/expert_parameter.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Roundoff of prescribed displacements, over the largest displacement.
    constexpr double applied_tolerance = 1e-10;



    std::string
    errors_of(const Verification           &found,
              const VerificationParameters &parameters)
    {
      std::ostringstream text;
      const auto         require = [&text](const double      value,
                                   const double      tolerance,
                                   const std::string what,
                                   const std::string tolerance_name) {
        if (!(value <= tolerance))
          text << (text.tellp() > 0 ? "; " : "") << what << ' ' << value
               << " (allowed: 'Algorithm/Acceptance/" << tolerance_name
               << "' = " << tolerance << ")";
      };
      if (!(found.residual.prescribed <= applied_tolerance))
        text << "prescribed displacements are off by "
             << found.residual.prescribed << " of the largest displacement";
      require(found.residual.equilibrium,
              parameters.residual_tolerance,
              "equilibrium residual with fresh statuses",
              "Residual tolerance");
      require(found.residual.contact,
              parameters.residual_tolerance,
              "weak contact condition with fresh statuses",
              "Residual tolerance");
      require(found.violation.normal_law,
              parameters.law_tolerance,
              "penetration, tension or pressure across a gap",
              "Law tolerance");
      require(found.violation.friction_law,
              parameters.law_tolerance,
              "violation of Coulomb's law",
              "Law tolerance");
      if (found.violation.fallen_through > 0)
        text << (text.tellp() > 0 ? "; " : "") << found.violation.fallen_through
             << " points have passed through the surface that they were on";
      return text.str();
    }
  } // namespace



  void
  VerificationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Residual tolerance",
      residual_tolerance,
      expert(
        "Largest equilibrium residual and weak contact condition of a "
        "converged "
        "step when nothing is frozen any more (both relative, as in Newton)."),
      Patterns::Double(0.));
    prm.add_parameter(
      "Law tolerance",
      law_tolerance,
      expert(
        "Largest violation of the contact law at a point of a converged step: "
        "of Signorini's conditions over the largest pressure of the pair and "
        "of "
        "Coulomb's law over the largest threshold, gap and slip counting with "
        "the stiffness of the contact. Pairs with more contact points than "
        "multipliers satisfy the law weakly and are exempt."),
      Patterns::Double(0.));
  }



  template <int dim>
  Verification
  verify_state(ContactProblem<dim>          &problem,
               const LA::BlockVector        &x,
               const VerificationParameters &parameters)
  {
    const SolveCounts counts = problem.counts;
    Verification      found;
    {
      const LiveScope<dim> nothing_frozen(problem.contact());
      found.residual  = problem.residual(x);
      found.violation = contact_violation(problem.contact());
    }
    found.residual.prescribed =
      problem.unapplied_displacement(x) /
      std::max(x.block(0).linfty_norm(), std::numeric_limits<double>::min());
    found.errors = errors_of(found, parameters);
    // back to the pairings of the algorithm
    problem.configure(x, false);
    problem.counts = counts;
    return found;
  }



  template Verification
  verify_state(ContactProblem<2> &,
               const LA::BlockVector &,
               const VerificationParameters &);
  template Verification
  verify_state(ContactProblem<3> &,
               const LA::BlockVector &,
               const VerificationParameters &);
} // namespace stickslip
