#include <stickslip/simulation/step_statistics.h>

namespace stickslip
{
  template <int dim>
  void
  add_step_statistics(const StepControl     &control,
                      const Attempt         &solved,
                      const SolveCounts     &counts,
                      const StepSolver<dim> &solver,
                      StatisticsTable       &table)
  {
    const Verification         &found           = solver.verification();
    const auto                 &violation       = found.violation;
    const CycleTreatmentCounts &cycle_treatment = solver.cycle_treatment.counts;
    table.add("step", control.steps().step_number());
    table.add("time", control.steps().time());
    table.add("algorithm", name_of(solved.algorithm));
    table.add("geometry_loops", counts.geometry_loops);
    table.add("threshold_loops", counts.threshold_loops);
    table.add("status_loops", counts.status_loops);
    table.add("newton_iterations", counts.newton_iterations);
    table.add("pairings", counts.pairings);
    table.add("linear_iterations", counts.linear_iterations);
    table.add("multigrid_setups", counts.multigrid_setups);
    table.add("direct_fallbacks", counts.direct_fallbacks);
    table.add("cuts", control.n_cuts());
    table.add("failed_newton_iterations", solver.failed_newton_iterations());
    table.add("cycles", cycle_treatment.cycles);
    table.add("adapted_r", cycle_treatment.adapted_scales);
    table.add("held_statuses", cycle_treatment.fixed_statuses);
    table.add("sparsity_rebuilds", counts.sparsity_rebuilds);
    table.add("assembly_seconds", counts.assembly_seconds);
    table.add("contact_seconds", counts.contact_seconds);
    table.add("setup_seconds", counts.setup_seconds);
    table.add("solve_seconds", counts.solve_seconds);
    table.add("max_penetration", violation.penetration);
    table.add("max_tension", violation.tension);
    table.add("max_disc_excess", violation.friction_cone_excess);
    table.add("max_stick_slip", violation.stick_slip);
    table.add("max_direction_error", violation.direction);
    table.add("normal_law_error", violation.normal_law);
    table.add("friction_law_error", violation.friction_law);
    table.add("fresh_residual", found.residual.equilibrium);
  }



  template void
  add_step_statistics(const StepControl &,
                      const Attempt &,
                      const SolveCounts &,
                      const StepSolver<2> &,
                      StatisticsTable &);
  template void
  add_step_statistics(const StepControl &,
                      const Attempt &,
                      const SolveCounts &,
                      const StepSolver<3> &,
                      StatisticsTable &);
} // namespace stickslip
