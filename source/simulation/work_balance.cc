#include <stickslip/simulation/work_balance.h>

#include <stickslip/simulation/final_results.h>

namespace stickslip
{
  void
  WorkBalance::add_to(StatisticsTable &statistics) const
  {
    statistics.add("external_work", external);
    statistics.add("friction_work", friction);
    statistics.add("contact_work", contact);
    statistics.add("stabilization_work", stabilization);
  }



  void
  WorkBalance::add_to(FinalResults &results,
                      const bool    with_stabilization) const
  {
    results.add("work", "external_work", external);
    results.add("work", "friction_work", friction);
    if (with_stabilization)
      results.add("work", "stabilization_work", stabilization);
  }
} // namespace stickslip
