#ifndef stickslip_simulation_estimated_error_h
#define stickslip_simulation_estimated_error_h

#include <stickslip/adaptivity/error_estimate.h>

#include <stickslip/output/field_output.h>
#include <stickslip/output/statistics_table.h>

#include <memory>

namespace stickslip
{
  /// The error of the last accepted state, if section `Adaptation` names an
  /// estimator, and what is shown of it.
  template <int dim>
  class EstimatedError
  {
  public:
    explicit EstimatedError(const AdaptationParameters &parameters);

    /// After ContactProblem::accept_step(). Collective.
    void
    update(ContactProblem<dim> &problem, const LA::BlockVector &x);

    /// Continues with an estimate of an earlier run, over all cells.
    void
    resume(const Vector<double> &indicators,
           const double          energy_norm,
           const MPI_Comm       &communicator);

    /// The state is another one now.
    void
    forget()
    {
      estimate.reset();
    }

    /// ErrorEstimator::is_rule()
    bool
    is_of_rule() const
    {
      return estimator != nullptr && estimator->is_rule();
    }

    /// Null without an estimator or a state.
    const ErrorEstimate *
    get() const
    {
      return estimate.get();
    }

    /// Adds the columns of an error to the present row.
    void
    add_to(StatisticsTable &table) const;

    /// The indicator of each cell, energy^1/2, and its level.
    NamedCellValues
    fields(const Triangulation<dim> &triangulation) const;

  private:
    std::unique_ptr<const ErrorEstimator<dim>> estimator;
    std::unique_ptr<const ErrorEstimate>       estimate;
  };
} // namespace stickslip

#endif
