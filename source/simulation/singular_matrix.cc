#include <stickslip/simulation/singular_matrix.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

namespace stickslip
{
  namespace
  {
    template <int dim>
    using Property = std::function<bool(const PointDiagnosis<dim> &)>;



    /// A body that contact alone can hold, and contact does not.
    template <int dim>
    std::optional<FailureExplanation>
    free_body(const FailedStep<dim> &step, const MPI_Comm communicator)
    {
      for (const FreeMotion &motion : step.free_motions)
        {
          const auto touches_body = [&](const PointDiagnosis<dim> &point) {
            return motion.concerns(step.pairs[point.pair].second);
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
              return pair.second.has_friction() && motion.concerns(pair.second);
            });
          FailureExplanation explanation;
          explanation.where = motion.text() + ".";
          if (n_closed == 0)
            {
              explanation.name = "body held by nothing";
              explanation.why =
                "the matrix is singular: only contact can hold this motion, "
                "and no contact point of the body is closed, at the start of "
                "the step or in the iterate that has let it go.";
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



    /// A body whose springs are lost in the roundoff.
    template <int dim>
    std::optional<FailureExplanation>
    weakly_held_body(const FailedStep<dim> &step)
    {
      if (step.weakly_held.empty())
        return {};
      FailureExplanation explanation;
      explanation.name = "weakly held body";
      explanation.why =
        "the matrix is singular up to roundoff: apart from contact only a "
        "spring holds this motion, and it is too soft beside the bodies to be "
        "seen.";
      explanation.where = step.weakly_held.front().text() + ".";
      explanation.advice =
        "a stiffer spring ('Stiffness', a force per area and length: 1e-6 of "
        "Young's modulus over the size of the body is still weak), or "
        "prescribe the displacement.";
      return explanation;
    }
  } // namespace



  template <int dim>
  FailureExplanation
  explain_singular_matrix(const FailedStep<dim> &step,
                          const MPI_Comm         communicator)
  {
    if (const auto explanation = free_body(step, communicator))
      return *explanation;
    if (const auto explanation = weakly_held_body(step))
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

  template FailureExplanation
  explain_singular_matrix(const FailedStep<2> &, const MPI_Comm);
  template FailureExplanation
  explain_singular_matrix(const FailedStep<3> &, const MPI_Comm);
} // namespace stickslip
