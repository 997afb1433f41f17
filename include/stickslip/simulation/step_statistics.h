#ifndef stickslip_simulation_step_statistics_h
#define stickslip_simulation_step_statistics_h

#include <stickslip/base/solve_counts.h>

#include <stickslip/output/statistics_table.h>

#include <stickslip/simulation/step_solver.h>

namespace stickslip
{
  /// Adds the columns of statistics.csv about an accepted step to the present
  /// row of @p table: the attempt @p solved, what it took (@p counts), what was
  /// tried before, what is wrong with the solution. doc/results.md explains
  /// them.
  template <int dim>
  void
  add_step_statistics(const StepControl     &control,
                      const Attempt         &solved,
                      const SolveCounts     &counts,
                      const StepSolver<dim> &solver,
                      StatisticsTable       &table);
} // namespace stickslip

#endif
