#ifndef stickslip_simulation_force_tables_h
#define stickslip_simulation_force_tables_h

#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/statistics_table.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/case_parameters.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// resultants.csv and reactions.csv: what contact pairs and supports transmit
  /// in each step. All functions are collective.
  class ForceTables
  {
  public:
    ForceTables(const CaseParameters &parameters, const MPI_Comm communicator);

    /// Continues the tables of an earlier run after @p time.
    void
    resume(const double time);

    /// A row of each table; a table without columns is not written. The
    /// reactions are those of the last evaluated state of @p problem; what
    /// reference points do follows them.
    template <int dim>
    void
    write(const unsigned int                         step,
          const double                               time,
          const std::vector<ContactResultants<dim>> &resultants,
          const ContactProblem<dim>                 &problem);

    const StatisticsTable &
    resultants() const
    {
      return resultant_table;
    }

    const StatisticsTable &
    reactions() const
    {
      return reaction_table;
    }

  private:
    std::vector<std::string> pair_names;
    StatisticsTable          resultant_table;
    StatisticsTable          reaction_table;
  };
} // namespace stickslip

#endif
