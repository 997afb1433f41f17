#include <stickslip/simulation/failure_explanation.h>

#include <stickslip/simulation/residual_trend.h>
#include <stickslip/simulation/singular_matrix.h>

#include <stickslip/strategy/solution_strategy.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace stickslip
{
  namespace
  {
    /// Facet changes among the last iterations that are more than Newton's
    /// first ones explain.
    constexpr unsigned int hopping_facet_changes = 8;

    /// A limit of Newton iterations below this may be the cause itself.
    constexpr unsigned int usual_iterations = 15;



    FailureExplanation
    inadmissible_state(const NoConvergence &failure)
    {
      FailureExplanation explanation;
      explanation.name  = "inadmissible deformation";
      explanation.why   = failure.reason + ".";
      explanation.where = failure.place.body.empty()
                            ? "the whole model."
                            : failure.place.in_words() + ".";
      explanation.advice =
        "a smaller 'Load stepping/Initial step' (and 'Minimum "
        "step'); a better mesh or fewer distorted cells there; a "
        "law that stands strong compression, such as neo-Hookean.";
      return explanation;
    }



    FailureExplanation
    rejected_state(const NoConvergence &failure)
    {
      return {"wrong state",
              failure.what(),
              "the points of the largest violation are in the diagnosis.",
              "a smaller 'Load stepping/Initial step'; tighter 'Algorithm/"
              "Geometry/Tolerance' and 'Threshold/Tolerance'."};
    }



    template <int dim>
    std::string
    advice_against(const CycleKind        cycle,
                   const PointGroup<dim> &group,
                   const FailedStep<dim> &step)
    {
      const std::string smaller = "a smaller 'Load stepping/Initial step'";
      if (cycle == CycleKind::pairing)
        return "make the master surface larger than what the slave reaches, "
               "exchange slave and master, or enlarge " +
               parameter_of(group, step, "Projection tolerance") + ".";
      if (cycle == CycleKind::facet)
        return parameter_of(group, step, "Normals") + " = smoothed; " +
               advice_to_freeze_geometry() + "; a larger " +
               parameter_of(group, step, "Facet overlap") + ".";
      if (cycle == CycleKind::direction)
        return smaller + "; a ten times smaller " +
               parameter_of(group, step, "Regularization/r_t") + ".";
      if (cycle == CycleKind::stick)
        return smaller + "; " + advice_to_fall_back() + ".";
      return smaller + "; a ten times smaller " +
             parameter_of(group, step, "Regularization/r_n") + "; " +
             advice_to_freeze_geometry() + ".";
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
      CycleKind       kind{};
      for (const CycleKind candidate : {CycleKind::pairing,
                                        CycleKind::contact,
                                        CycleKind::stick,
                                        CycleKind::direction,
                                        CycleKind::facet})
        {
          const auto group = find_group<dim>(
            step,
            [&](const auto &point) { return point.cycle == candidate; },
            communicator);
          if (group.n > largest.n)
            {
              largest = group;
              kind    = candidate;
            }
        }
      const unsigned int n_with_facet =
        find_group<dim>(
          step,
          [](const auto &point) { return point.changes_facet; },
          communicator)
          .n;
      FailureExplanation explanation;
      explanation.name = "cycle: " + name_of(kind);
      explanation.why =
        step.cycle ? "all contact statuses repeat every " +
                       std::to_string(step.cycle.period) + " iterations: "
                   : "statuses of some points repeat while others still move: ";
      explanation.why +=
        std::to_string(all.n) +
        (all.n == 1 ? " point alternates" : " points alternate") +
        ", most of them " + name_of(kind);
      if (n_with_facet > 0 && kind != CycleKind::facet)
        explanation.why += " (" + std::to_string(n_with_facet) +
                           " with a change of the master facet)";
      explanation.why += ".";
      explanation.where = describe(largest, step);
      // Where the geometry changes as well, it is the explanation.
      explanation.advice =
        advice_against(2 * n_with_facet >= all.n ? CycleKind::facet : kind,
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
          return point.n_facet_changes >= hopping_facet_changes;
        },
        communicator);
      if (group.n == 0)
        return {};
      return FailureExplanation{
        "points hop between facets",
        "points go from one master facet to another in most iterations.",
        describe(group, step),
        advice_against(CycleKind::facet, group, step)};
    }



    template <int dim>
    std::optional<FailureExplanation>
    lost_contact(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      const auto group = find_group<dim>(
        step,
        [](const auto &point) {
          return point.was_paired && point.state == ContactState::unpaired &&
                 !point.is_far;
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



    /// Contact forces that the stiffness of the bodies alone has to tell.
    template <int dim>
    std::optional<FailureExplanation>
    body_on_springs(const FailedStep<dim> &step)
    {
      if (step.failure.cause != FailureCause::linear_solver ||
          step.held_by_springs.empty())
        return {};
      return FailureExplanation{
        "body held by contact and springs",
        step.failure.reason +
          ": the algorithm looks for the contact forces "
          "with the stiffness of the bodies alone, and "
          "beside contact only soft springs hold this "
          "motion.",
        step.held_by_springs.front().text() + ".",
        "another algorithm ('Algorithm/Name = automatic'); stiffer springs, or "
        "prescribe the displacement."};
    }



    /// 'Algorithm/Geometry/Max iterations', for example.
    std::string
    limit_of_loop(const std::string &loop)
    {
      std::string section = loop;
      section[0]          = std::toupper(section[0]);
      return "'Algorithm/" + section + "/Max iterations'";
    }



    std::optional<FailureExplanation>
    loop_or_budget(const NoConvergence &failure)
    {
      const std::string smaller = "a smaller 'Load stepping/Initial step'";
      switch (failure.cause)
        {
          case FailureCause::loop_limit:
            return FailureExplanation{"outer loop at its limit",
                                      failure.what(),
                                      "the whole model.",
                                      "more passes of this loop (" +
                                        limit_of_loop(failure.place.loop) +
                                        "); " + smaller + "; " +
                                        advice_to_avoid_loops() + "."};
          case FailureCause::loop_cycle:
            return FailureExplanation{"outer loop repeats itself",
                                      failure.what(),
                                      "the whole model.",
                                      smaller + "; " + advice_to_avoid_loops() +
                                        "."};
          case FailureCause::budget:
            return FailureExplanation{
              "too many iterations",
              failure.what(),
              "the whole model.",
              smaller +
                " (and 'Minimum step'); a larger 'Algorithm/Newton/Max "
                "iterations'."};
          default:
            return {};
        }
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
                    "'Load stepping/Predictor = none'."};
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
                : "a smaller 'Load stepping/Initial step'; " +
                    advice_to_fall_back() + "."};
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
    if (step.failure.cause == FailureCause::rejected)
      return rejected_state(step.failure);
    if (step.failure.cause == FailureCause::singular)
      return explain_singular_matrix(step, communicator);
    if (const auto explanation = body_on_springs(step))
      return *explanation;
    for (const auto &look_for :
         {&cycle<dim>, &hopping<dim>, &lost_contact<dim>})
      if (const auto explanation = look_for(step, communicator))
        return *explanation;
    if (const auto explanation = loop_or_budget(step.failure))
      return *explanation;
    return iteration_limit(step);
  }

  template FailureExplanation
  explain_failure(const FailedStep<2> &, const MPI_Comm);
  template FailureExplanation
  explain_failure(const FailedStep<3> &, const MPI_Comm);
} // namespace stickslip
