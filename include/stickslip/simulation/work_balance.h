#ifndef stickslip_simulation_work_balance_h
#define stickslip_simulation_work_balance_h

#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/statistics_table.h>

#include <vector>

namespace stickslip
{
  class FinalResults;

  /// Work since the start of a run.
  struct WorkBalance
  {
    double external = 0.; ///< of loads and supports
    double friction = 0.; ///< dissipated by friction
    /// What all contact forces take from the bodies. More than friction
    /// dissipates is an error of the discretization: normals that jump between
    /// facets brake without friction.
    double contact = 0.;
    /// Dissipated by viscous stabilization (see ViscousStabilization); it tells
    /// how far the path is from a quasi-static one.
    double stabilization = 0.;

    /// Adds what friction has dissipated in a step.
    template <int dim>
    void
    add_friction(const std::vector<ContactResultants<dim>> &of_pairs)
    {
      for (const auto &pair : of_pairs)
        friction -= pair.friction_work;
    }

    /// Adds a column for each.
    void
    add_to(StatisticsTable &statistics) const;

    /// Adds external and friction work, and @p with_stabilization that, too.
    void
    add_to(FinalResults &results, const bool with_stabilization) const;
  };
} // namespace stickslip

#endif
