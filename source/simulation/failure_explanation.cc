#include <stickslip/simulation/failure_explanation.h>
#include <stickslip/simulation/residual_trend.h>

#include <algorithm>
#include <optional>

namespace stickslip
{
  namespace
  {
    /// Facet changes among the last iterations that are more than Newton's
    /// first ones explain.
    constexpr unsigned int many_facet_changes = 8;

    /// A limit of Newton iterations below this may be the cause itself.
    constexpr unsigned int usual_iterations = 15;



    template <int dim>
    using Property = std::function<bool(const PointDiagnosis<dim> &)>;



    FailureExplanation
    inadmissible_state(const NoConvergence &failure)
    {
      const std::string  text  = failure.what();
      const std::size_t  where = text.find(" in body ");
      FailureExplanation explanation;
      explanation.name  = "inadmissible deformation";
      explanation.why   = text.substr(0, where);
      explanation.where = where == std::string::npos
                            ? "the whole model."
                            : text.substr(where + std::string(" in ").size());
      explanation.advice =
        "a smaller 'Load stepping/Initial step' (and 'Minimum "
        "step'); a better mesh or fewer distorted cells there; a "
        "law that stands strong compression, such as neo-Hookean.";
      return explanation;
    }



    bool
    is_closed(const ContactState state)
    {
      return state == ContactState::stick || state == ContactState::slip;
    }



    /// A body that contact alone can hold, and contact does not.
    template <int dim>
    std::optional<FailureExplanation>
    free_body(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      for (const std::string &motion : step.free_motions)
        {
          const auto touches_body = [&](const PointDiagnosis<dim> &point) {
            const auto &pair = step.pairs[point.pair].second;
            return motion.find("'" + pair.slave_body + "'") !=
                     std::string::npos ||
                   motion.find("'" + pair.master_body + "'") !=
                     std::string::npos;
          };
          const auto count = [&](const Property<dim> &has_property) {
            return find_group<dim>(
                     step,
                     [&](const auto &point) {
                       return touches_body(point) && is_closed(point.state) &&
                              has_property(point);
                     },
                     communicator)
              .n;
          };
          const unsigned int n_closed =
            count([](const auto &) { return true; });
          const unsigned int n_with_threshold =
            count([](const auto &point) { return point.has_threshold; });
          const unsigned int n_stick      = count([](const auto &point) {
            return point.state == ContactState::stick;
          });
          const bool         has_friction = std::any_of(
            step.pairs.begin(), step.pairs.end(), [&](const auto &pair) {
              return pair.second.has_friction() &&
                     (motion.find("'" + pair.second.slave_body + "'") !=
                        std::string::npos ||
                      motion.find("'" + pair.second.master_body + "'") !=
                        std::string::npos);
            });
          FailureExplanation explanation;
          explanation.where = motion + ".";
          if (n_closed == 0)
            {
              explanation.name = "body held by nothing";
              explanation.why =
                "the matrix is singular: only contact can hold this motion, "
                "and no contact point of the body is closed.";
              explanation.advice =
                "let the bodies touch at the start, prescribe the displacement "
                "of the body, or give it a weak spring ('Type = spring').";
              return explanation;
            }
          if (has_friction && n_with_threshold == 0)
            {
              explanation.name = "no friction threshold yet";
              explanation.why =
                "the matrix is singular: only friction can hold this motion, "
                "and no closed point carries pressure yet.";
              explanation.advice =
                "press first: one load step with the pressing load alone "
                "('Load stepping/Requested times'), the sideways load later.";
              return explanation;
            }
          if (n_stick == 0)
            {
              explanation.name = "sliding body held by nothing";
              explanation.why =
                "the matrix is singular: all " + std::to_string(n_closed) +
                " closed points of the body slip, so nothing holds "
                "this motion.";
              explanation.advice =
                "prescribe a displacement in place of the force that moves "
                "the body, or give it a weak spring ('Type = spring').";
              return explanation;
            }
        }
      return {};
    }



    template <int dim>
    FailureExplanation
    singular_matrix(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      if (const auto explanation = free_body(step, communicator))
        return *explanation;
      const auto group = find_group<dim>(
        step,
        [](const auto &point) { return is_closed(point.state); },
        communicator);
      FailureExplanation explanation;
      explanation.name = "singular matrix";
      if (group.n == 0)
        {
          explanation.why =
            "the matrix is singular, and no contact point is closed.";
          explanation.where = "a body, or a part of one, without stiffness.";
          explanation.advice =
            "look at the material parameters and at the boundary conditions of "
            "all bodies; a smaller 'Load stepping/Initial step'.";
          return explanation;
        }
      explanation.why =
        "the matrix is singular although every body is held: "
        "multipliers of contact that nothing determines.";
      explanation.where = "closed: " + describe(group, step);
      explanation.advice =
        "keep nodes that other conditions hold or that two pairs share out of "
        "one of them: " +
        parameter_of(group, step, "Excluded boundaries") +
        "; a smaller 'Load stepping/Initial step'.";
      return explanation;
    }



    template <int dim>
    std::string
    advice_against(const std::string     &cycle,
                   const PointGroup<dim> &group,
                   const FailedStep<dim> &step)
    {
      const std::string smaller = "a smaller 'Load stepping/Initial step'";
      if (cycle == name_of(CycleKind::pairing))
        return "make the master surface larger than what the slave reaches, "
               "exchange slave and master, or enlarge " +
               parameter_of(group, step, "Projection tolerance") + ".";
      if (cycle == name_of(CycleKind::facet))
        return parameter_of(group, step, "Normals") +
               " = smoothed; 'Algorithm/Name = PNM'; a larger " +
               parameter_of(group, step, "Facet overlap") + ".";
      if (cycle == name_of(CycleKind::direction))
        return smaller + "; a ten times smaller " +
               parameter_of(group, step, "Regularization/r_t") + ".";
      if (cycle == name_of(CycleKind::stick))
        return smaller + "; 'Algorithm/Name = PNM', then FPM.";
      return smaller + "; a ten times smaller " +
             parameter_of(group, step, "Regularization/r_n") +
             "; 'Algorithm/Name = PNM'.";
    }



    template <int dim>
    std::optional<FailureExplanation>
    cycle(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      const auto all = find_group<dim>(
        step, [](const auto &point) { return point.period > 0; }, communicator);
      if (all.n == 0)
        return {};
      PointGroup<dim> largest;
      std::string     kind;
      for (const CycleKind candidate : {CycleKind::pairing,
                                        CycleKind::contact,
                                        CycleKind::stick,
                                        CycleKind::direction,
                                        CycleKind::facet})
        {
          const auto group = find_group<dim>(
            step,
            [&](const auto &point) {
              return point.cycle == name_of(candidate);
            },
            communicator);
          if (group.n > largest.n)
            {
              largest = group;
              kind    = name_of(candidate);
            }
        }
      const unsigned int n_with_facet =
        find_group<dim>(
          step,
          [](const auto &point) { return point.changes_facet; },
          communicator)
          .n;
      FailureExplanation explanation;
      explanation.name = "cycle: " + kind;
      explanation.why =
        step.cycle ? "all contact statuses repeat every " +
                       std::to_string(step.cycle.period) + " iterations: "
                   : "statuses of some points repeat while others still move: ";
      explanation.why +=
        std::to_string(all.n) +
        (all.n == 1 ? " point alternates" : " points alternate") +
        ", most of them " + kind;
      if (n_with_facet > 0 && kind != name_of(CycleKind::facet))
        explanation.why += " (" + std::to_string(n_with_facet) +
                           " with a change of the master facet)";
      explanation.why += ".";
      explanation.where = describe(largest, step);
      // Where the geometry changes as well, it is the explanation.
      explanation.advice =
        advice_against(2 * n_with_facet >= all.n ? name_of(CycleKind::facet)
                                                 : kind,
                       largest,
                       step);
      return explanation;
    }



    template <int dim>
    std::optional<FailureExplanation>
    hopping(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      const auto group = find_group<dim>(
        step,
        [](const auto &point) {
          return point.n_facet_changes >= many_facet_changes;
        },
        communicator);
      if (group.n == 0)
        return {};
      return FailureExplanation{
        "points hop between facets",
        "points go from one master facet to another in most iterations.",
        describe(group, step),
        advice_against(name_of(CycleKind::facet), group, step)};
    }



    template <int dim>
    std::optional<FailureExplanation>
    lost_contact(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      const auto group = find_group<dim>(
        step,
        [](const auto &point) {
          return point.was_paired && point.state == ContactState::unpaired;
        },
        communicator);
      if (group.n == 0)
        return {};
      return FailureExplanation{
        "points lose their master",
        "points that had a master face opposite have none in this step: they "
        "slide beyond its end, or the bodies move far.",
        describe(group, step),
        "a smaller 'Load stepping/Initial step'; exchange slave and master, "
        "or make the master surface larger; a larger " +
          parameter_of(group, step, "Search distance") + "."};
    }



    template <int dim>
    FailureExplanation
    iteration_limit(const FailedStep<dim> &step)
    {
      const std::string where =
        step.iterations.empty() ? "the whole model."
        : equilibrium_is_worse(step.iterations.back(), step.newton)
          ? "the equilibrium of forces."
          : "the contact conditions.";
      switch (residual_trend(step.iterations, step.newton))
        {
          case ResidualTrend::small:
            return {
              "unknowns that do not settle",
              "the residual is below its tolerances, but displacements or "
              "multipliers change more than 'Increment tolerance' allows.",
              "unknowns without stiffness, or multipliers of roundoff.",
              "a larger 'Algorithm/Newton/Increment tolerance'; a smaller "
              "'Load stepping/Initial step'."};
          case ResidualTrend::grows:
            return {"diverging residual",
                    "the residual grows.",
                    where,
                    "a smaller 'Load stepping/Initial step'; "
                    "'Algorithm/Newton/Line search = backtracking'; 'Load "
                    "stepping/Predictor = none'."};
          case ResidualTrend::stagnates:
            return {"residual above its tolerance",
                    "the residual stands just above its tolerance and does not "
                    "fall any more, as roundoff does.",
                    where,
                    "'Equilibrium tolerance' and 'Contact tolerance' of "
                    "'Algorithm/Newton' ten times larger; bodies of less "
                    "different stiffness."};
          case ResidualTrend::falls_slowly:
            return {"slow convergence",
                    "the residual falls in every iteration, but too slowly for "
                    "'Algorithm/Newton/Max iterations' = " +
                      std::to_string(step.newton.max_iterations) + ".",
                    where,
                    "a larger 'Algorithm/Newton/Max iterations'; "
                    "'Algorithm/Tangent = consistent'; a smaller 'Load "
                    "stepping/Initial step'."};
          case ResidualTrend::unclear:
            break;
        }
      return {"iteration limit",
              step.failure.what(),
              where,
              step.newton.max_iterations < usual_iterations
                ? "a larger 'Algorithm/Newton/Max iterations'; a smaller 'Load "
                  "stepping/Initial step'."
                : "a smaller 'Load stepping/Initial step'; 'Algorithm/Name = "
                  "PNM', then FPM."};
    }
  } // namespace



  std::string
  FailureExplanation::text(const std::string &indent) const
  {
    return indent + "why:   " + why + "\n" + indent + "where: " + where + "\n" +
           indent + "try:   " + advice;
  }



  template <int dim>
  FailureExplanation
  explain_failure(const FailedStep<dim> &step, const MPI_Comm communicator)
  {
    if (step.failure.cause == FailureCause::inadmissible)
      return inadmissible_state(step.failure);
    if (step.failure.cause == FailureCause::singular)
      return singular_matrix(step, communicator);
    for (const auto &look_for :
         {&cycle<dim>, &hopping<dim>, &lost_contact<dim>})
      if (const auto explanation = look_for(step, communicator))
        return *explanation;
    if (step.failure.cause == FailureCause::loop_limit)
      return {"outer loop at its limit",
              step.failure.what(),
              "the whole model.",
              "more passes of this loop ('Algorithm/Geometry/Max iterations', "
              "'Threshold' or 'Status'); a smaller 'Load stepping/Initial "
              "step'; 'Algorithm/Name = GNM', which has no such loops."};
    return iteration_limit(step);
  }

  template FailureExplanation
  explain_failure(const FailedStep<2> &, const MPI_Comm);
  template FailureExplanation
  explain_failure(const FailedStep<3> &, const MPI_Comm);
} // namespace stickslip
