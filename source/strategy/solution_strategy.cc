#include <stickslip/strategy/solution_strategy.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

#include <limits>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Failures of Newton in a row that a loop over thresholds outlives where
    /// an inner loop over the statuses is there to end the rest.
    constexpr unsigned int few_failures = 5;

    constexpr unsigned int any_number =
      std::numeric_limits<unsigned int>::max();



    struct NamedStrategy
    {
      Algorithm        algorithm;
      SolutionStrategy strategy;
    };



    /// All but `custom`, which the parameters define.
    const std::vector<NamedStrategy> &
    named_strategies()
    {
      constexpr Treatment                     fixed = Treatment::fixed_point;
      constexpr Treatment                     live  = Treatment::newton;
      static const std::vector<NamedStrategy> strategies = {
        {Algorithm::fpm, {{{fixed, fixed, fixed}}}},
        {Algorithm::pnm, {{{fixed, live, live}}}},
        {Algorithm::gnm, {{{live, live, live}}}},
        {Algorithm::gcp,
         {{{fixed, fixed, live}},
          IncrementSolver::projected_conjugate_gradient}}};
      return strategies;
    }



    /// What `automatic` tries, one after the other.
    const std::vector<Algorithm> &
    automatic_sequence()
    {
      static const std::vector<Algorithm> sequence = {Algorithm::gnm,
                                                      Algorithm::pnm,
                                                      Algorithm::fpm};
      return sequence;
    }



    std::string
    entry_for(const Algorithm algorithm)
    {
      return "'Algorithm/Name = " + name_of(algorithm) + "'";
    }



    const Choices<Treatment> &
    all_treatments()
    {
      static const Choices<Treatment> choices = {{"newton", Treatment::newton},
                                                 {"fixed point",
                                                  Treatment::fixed_point}};
      return choices;
    }



    const Choices<Acceleration> &
    all_accelerations()
    {
      static const Choices<Acceleration> choices = {
        {"Anderson", Acceleration::anderson}, {"none", Acceleration::none}};
      return choices;
    }



    const Choices<Tangent> &
    all_tangents()
    {
      static const Choices<Tangent> choices = {{"consistent",
                                                Tangent::consistent},
                                               {"quasi", Tangent::quasi}};
      return choices;
    }
  } // namespace



  const Choices<Algorithm> &
  all_algorithms()
  {
    static const Choices<Algorithm> choices = {{"automatic",
                                                Algorithm::automatic},
                                               {"FPM", Algorithm::fpm},
                                               {"PNM", Algorithm::pnm},
                                               {"GNM", Algorithm::gnm},
                                               {"GCP", Algorithm::gcp},
                                               {"custom", Algorithm::custom}};
    return choices;
  }



  const std::string &
  name_of(const Algorithm algorithm)
  {
    return name_of(algorithm, all_algorithms());
  }



  void
  LoopParameters::add_parameters(ParameterHandler  &prm,
                                 const std::string &what,
                                 const std::string &change)
  {
    add_choice(prm,
               "Treatment",
               treatment,
               all_treatments(),
               expert("Only with 'Name = custom'. newton: the " + what +
                      " is recomputed in every residual and linearized. "
                      "fixed point: it is frozen during Newton and refreshed "
                      "in a loop."));
    prm.add_parameter(
      "Tolerance",
      tolerance,
      expert("The fixed-point loop has converged when its change is at "
             "most this: " +
             change + "."),
      Patterns::Double(0.));
    prm.add_parameter("Max iterations",
                      max_iterations,
                      expert(
                        "Largest number of passes of its fixed-point loop."),
                      Patterns::Integer(1));
  }



  void
  LoopParameters::add_acceleration(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Acceleration",
      acceleration,
      all_accelerations(),
      expert(
        "How the fixed-point loop finds the start of its next pass. Anderson: "
        "the combination of the last passes with the smallest residual, which "
        "settles also where plain passes contract slowly or not at all. none: "
        "the result of the last pass, as in the paper."));
  }



  void
  AlgorithmParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Name",
      name,
      all_algorithms(),
      "FPM: fixed points on geometry, friction threshold and contact status. "
      "PNM: fixed point on the geometry, the rest in Newton. GNM: everything "
      "in Newton. automatic: GNM, and in steps where it cycles, stagnates or "
      "ends in a wrong state PNM and then FPM. GCP: fixed points on geometry "
      "and threshold, statuses from a projected conjugate gradient in the "
      "multipliers; for comparison, needs 'Quadrature = segments' or 'nodal' "
      "and bodies that "
      "are supported without contact. custom: what the Treatment of each "
      "quantity says.");
    add_choice(
      prm,
      "Tangent",
      tangent,
      all_tangents(),
      expert(
        "consistent: all geometric terms of a live geometry, converges "
        "quadratically. quasi: without the second variations (paper, 3.2.4)."));
    prm.enter_subsection("Geometry");
    geometry.add_parameters(
      prm,
      "contact geometry",
      "largest displacement change since the last refresh "
      "over the largest displacement (Res(geom))");
    geometry.add_acceleration(prm);
    prm.leave_subsection();
    prm.enter_subsection("Threshold");
    threshold.add_parameters(prm,
                             "friction threshold",
                             "largest change of a threshold over the largest "
                             "threshold (Res(seuil))");
    threshold.add_acceleration(prm);
    prm.leave_subsection();
    prm.enter_subsection("Status");
    status.add_parameters(prm,
                          "contact status",
                          "number of points that opened or closed");
    prm.leave_subsection();
    prm.enter_subsection("Newton");
    newton.add_parameters(prm);
    prm.leave_subsection();
  }



  void
  AlgorithmParameters::check(const std::string &path) const
  {
    if (name == Algorithm::custom)
      return;
    for (const auto &[section, loop] : {std::make_pair("Geometry", &geometry),
                                        std::make_pair("Threshold", &threshold),
                                        std::make_pair("Status", &status)})
      if (loop->treatment != LoopParameters().treatment)
        throw UserError("'" + path + "/" + section + "/Treatment' is '" +
                        name_of(loop->treatment, all_treatments()) +
                        "', but 'Algorithm/Name = " + name_of(name) +
                        "' has its own treatments. Remove it, or set "
                        "'Algorithm/Name = custom'.");
  }



  SolutionStrategy
  strategy_of(const Algorithm algorithm, const AlgorithmParameters &parameters)
  {
    for (const NamedStrategy &named : named_strategies())
      if (named.algorithm == algorithm)
        return named.strategy;
    AssertThrow(algorithm == Algorithm::custom, ExcInternalError());
    return {{{parameters.geometry.treatment,
              parameters.threshold.treatment,
              parameters.status.treatment}}};
  }



  std::vector<FixedPointLoop>
  make_loops(const SolutionStrategy                   &strategy,
             const AlgorithmParameters                &parameters,
             const std::array<FreezableQuantity *, 3> &quantities,
             SolveCounts                              &counts)
  {
    const std::array<const LoopParameters *, 3> loop_parameters = {
      {&parameters.geometry, &parameters.threshold, &parameters.status}};
    const std::array<unsigned int *, 3> loop_counts = {
      {&counts.geometry_loops, &counts.threshold_loops, &counts.status_loops}};

    std::vector<FixedPointLoop> loops;
    for (unsigned int i = 0; i < 3; ++i)
      {
        FixedPointLoop loop;
        loop.quantity       = quantities[i];
        loop.is_live        = strategy.treatments[i] == Treatment::newton;
        loop.tolerance      = loop_parameters[i]->tolerance;
        loop.max_iterations = loop_parameters[i]->max_iterations;
        loop.is_accelerated =
          loop_parameters[i]->acceleration == Acceleration::anderson;
        loop.n_loops = loop_counts[i];
        loops.push_back(loop);
      }
    loops[2].is_relative = false; // a number of points
    // With its first thresholds, far from the final ones, a live status may
    // cycle in Newton indefinitely, as it does in the status loop of FPM; and
    // so may stick and slip, which are live in all algorithms.
    if (!loops[1].is_live)
      loops[1].n_failures_outlived =
        loops[2].is_live ? any_number : few_failures;
    return loops;
  }



  std::vector<Algorithm>
  fallback_sequence(const Algorithm chosen, const bool has_contact)
  {
    if (chosen != Algorithm::automatic)
      return {chosen};
    return has_contact ? automatic_sequence()
                       : std::vector<Algorithm>{automatic_sequence().front()};
  }



  namespace
  {
    bool
    solves_for_multipliers(const Algorithm algorithm)
    {
      return algorithm != Algorithm::automatic &&
             strategy_of(algorithm, AlgorithmParameters()).increment_solver ==
               IncrementSolver::projected_conjugate_gradient;
    }
  } // namespace



  bool
  needs_law_per_multiplier(const Algorithm algorithm)
  {
    return solves_for_multipliers(algorithm);
  }



  bool
  needs_held_bodies(const Algorithm algorithm)
  {
    return solves_for_multipliers(algorithm);
  }



  std::string
  advice_to_freeze_geometry()
  {
    for (const Algorithm algorithm : automatic_sequence())
      if (strategy_of(algorithm, AlgorithmParameters()).treatments[0] ==
          Treatment::fixed_point)
        return entry_for(algorithm);
    throw ExcInternalError();
  }



  std::string
  advice_to_fall_back()
  {
    std::string text;
    for (unsigned int i = 1; i < automatic_sequence().size(); ++i)
      text += i == 1 ? entry_for(automatic_sequence()[i])
                     : ", then " + name_of(automatic_sequence()[i]);
    return text;
  }



  std::string
  advice_to_avoid_loops()
  {
    return entry_for(automatic_sequence().front()) +
           ", which has no such loops";
  }
} // namespace stickslip
