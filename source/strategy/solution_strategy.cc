#include <stickslip/strategy/solution_strategy.h>

#include <stickslip/base/expert_parameter.h>

#include <limits>
#include <map>

namespace stickslip
{
  namespace
  {
    /// Is geometry, threshold, status live?
    using LiveFlags = std::array<bool, 3>;

    constexpr unsigned int most_failures =
      std::numeric_limits<unsigned int>::max();



    const std::map<std::string, LiveFlags> &
    named_algorithms()
    {
      static const std::map<std::string, LiveFlags> algorithms = {
        {"FPM", {{false, false, false}}},
        {"PNM", {{false, true, true}}},
        {"GCP", {{false, false, true}}},
        {"GNM", {{true, true, true}}}};
      return algorithms;
    }
  } // namespace



  void
  LoopParameters::add_parameters(ParameterHandler  &prm,
                                 const std::string &what,
                                 const std::string &change)
  {
    prm.add_parameter("Treatment",
                      treatment,
                      expert(
                        "Only with 'Name = custom'. newton: the " + what +
                        " is recomputed in every residual and linearized. "
                        "fixed point: it is frozen during Newton and refreshed "
                        "in a loop."),
                      Patterns::Selection("newton|fixed point"));
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
    prm.add_parameter(
      "Acceleration",
      acceleration,
      expert(
        "How the fixed-point loop finds the start of its next pass. Anderson: "
        "the combination of the last passes with the smallest residual, which "
        "settles also where plain passes contract slowly or not at all. none: "
        "the result of the last pass, as in the paper."),
      Patterns::Selection("Anderson|none"));
  }



  void
  AlgorithmParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Name",
      name,
      "FPM: fixed points on geometry, friction threshold and contact status. "
      "PNM: fixed point on the geometry, the rest in Newton. GNM: everything "
      "in Newton. automatic: GNM, and in steps where it cycles, stagnates or "
      "ends in a wrong state PNM and then FPM. GCP: fixed points on geometry "
      "and threshold, statuses from a projected conjugate gradient in the "
      "multipliers; for comparison, needs 'Quadrature = nodal' and bodies that "
      "are supported without contact. custom: what the Treatment of each "
      "quantity says.",
      Patterns::Selection("automatic|FPM|PNM|GNM|GCP|custom"));
    prm.add_parameter(
      "Tangent",
      tangent,
      expert(
        "consistent: all geometric terms of a live geometry, converges "
        "quadratically. quasi: without the second variations (paper, 3.2.4)."),
      Patterns::Selection("consistent|quasi"));
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



  std::vector<FixedPointLoop>
  make_loops(const std::string                        &name,
             const AlgorithmParameters                &parameters,
             const std::array<FreezableQuantity *, 3> &quantities,
             SolveCounts                              &counts)
  {
    const std::array<const LoopParameters *, 3> loop_parameters = {
      {&parameters.geometry, &parameters.threshold, &parameters.status}};
    const std::array<unsigned int *, 3> loop_counts = {
      {&counts.geometry_loops, &counts.threshold_loops, &counts.status_loops}};
    const auto named = named_algorithms().find(name);

    std::vector<FixedPointLoop> loops;
    for (unsigned int i = 0; i < 3; ++i)
      {
        FixedPointLoop loop;
        loop.quantity       = quantities[i];
        loop.is_live        = named != named_algorithms().end()
                                ? named->second[i]
                                : loop_parameters[i]->treatment == "newton";
        loop.tolerance      = loop_parameters[i]->tolerance;
        loop.max_iterations = loop_parameters[i]->max_iterations;
        loop.is_accelerated = loop_parameters[i]->acceleration == "Anderson";
        loop.n_loops        = loop_counts[i];
        loops.push_back(loop);
      }
    loops[2].is_relative = false; // a number of points
    // With its first thresholds, far from the final ones, a live status may
    // cycle in Newton for ever, as it does in the status loop of FPM; and so
    // may stick and slip, which are live in all algorithms.
    if (!loops[1].is_live)
      loops[1].n_failures_outlived = loops[2].is_live ? most_failures : 5;
    return loops;
  }
} // namespace stickslip
