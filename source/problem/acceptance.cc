#include <stickslip/problem/acceptance.h>

#include <stickslip/base/expert_parameter.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Roundoff of prescribed displacements, over the largest displacement.
    constexpr double applied_tolerance = 1e-10;



    std::string
    complaint_about(const Acceptance           &found,
                    const AcceptanceParameters &parameters)
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



    /// The pairing of all points, to be brought back later.
    template <int dim>
    class FrozenFrames
    {
    public:
      explicit FrozenFrames(ContactAssembler<dim> &contact)
        : contact(contact)
      {
        for (const auto &pair : contact.contact_pairs())
          for (const auto &point : pair->points)
            frames.push_back(
              {point.frame, point.facet_changes, point.pairing_changes});
      }

      void
      restore() const
      {
        auto saved = frames.begin();
        for (const auto &pair : contact.contact_pairs())
          for (auto &point : pair->points)
            {
              point.frame           = saved->frame;
              point.facet_changes   = saved->facet_changes;
              point.pairing_changes = saved->pairing_changes;
              ++saved;
              // the patch may be another one by now
              pair->patch->relocate(point.frame);
            }
      }

    private:
      struct Saved
      {
        ContactFrame<dim> frame;
        unsigned int      facet_changes;
        unsigned int      pairing_changes;
      };

      ContactAssembler<dim> &contact;
      std::vector<Saved>     frames;
    };
  } // namespace



  void
  AcceptanceParameters::add_parameters(ParameterHandler &prm)
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
  Acceptance
  examine(ContactProblem<dim>        &problem,
          const LA::BlockVector      &x,
          const AcceptanceParameters &parameters)
  {
    ContactAssembler<dim> &contact = problem.contact();
    const Liveness         live    = contact.live;
    const SolveCounts      counts  = problem.counts;

    std::optional<FrozenFrames<dim>> frozen;
    if (!(live.geometry && live.threshold && live.status))
      {
        frozen.emplace(contact);
        contact.live = Liveness();
        problem.forget_state();
      }
    Acceptance found;
    found.residual = problem.residual(x);
    found.residual.prescribed /=
      std::max(x.block(0).linfty_norm(), std::numeric_limits<double>::min());
    found.violation = contact_violation(contact);
    found.complaint = complaint_about(found, parameters);

    problem.counts = counts;
    if (frozen)
      {
        contact.live = live;
        frozen->restore();
        problem.forget_state();
      }
    return found;
  }

  template Acceptance
  examine(ContactProblem<2> &,
          const LA::BlockVector &,
          const AcceptanceParameters &);
  template Acceptance
  examine(ContactProblem<3> &,
          const LA::BlockVector &,
          const AcceptanceParameters &);
} // namespace stickslip
