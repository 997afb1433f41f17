#ifndef stickslip_simulation_run_output_h
#define stickslip_simulation_run_output_h

#include <stickslip/contact/results/contact_result.h>

#include <stickslip/output/contact_output.h>
#include <stickslip/output/field_output.h>
#include <stickslip/output/point_values.h>
#include <stickslip/output/statistics_table.h>
#include <stickslip/output/tool_output.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/force_tables.h>

#include <stickslip/strategy/load_stepping.h>

#include <vector>

namespace stickslip
{
  /// All files with results of steps. All functions are collective.
  template <int dim>
  class RunOutput
  {
  public:
    /// @p parameters must outlive this object.
    RunOutput(const CaseParameters &parameters,
              const Bodies         &bodies,
              const MPI_Comm       &communicator);

    /// Where the named points are in the mesh of @p problem. Throws UserError.
    void
    locate(const ContactProblem<dim> &problem);

    /// Tables and indices go on after @p time.
    void
    resume(const double time);

    /// The fields and values of the last accepted step; @p faces are its contact,
    /// @p cell_values further fields.
    void
    write(const LoadStepping                        &steps,
          ContactProblem<dim>                       &problem,
          const std::vector<ContactFaceResult<dim>> &faces,
          const NamedCellValues                     &cell_values);

    const PointValues<dim> &
    points() const
    {
      return point_values;
    }

  private:
    const CaseParameters &parameters;
    FieldOutput<dim>      field_output;
    ContactOutput<dim>    contact_output;
    ToolOutput<dim>       tool_output;
    PointValues<dim>      point_values;

  public:
    StatisticsTable statistics;
    ForceTables     forces;

    /// What names of results may mean, in this order.
    const std::vector<const StatisticsTable *> tables;
  };
} // namespace stickslip

#endif
