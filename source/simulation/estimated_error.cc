#include <stickslip/simulation/estimated_error.h>

#include <cmath>

namespace stickslip
{
  template <int dim>
  EstimatedError<dim>::EstimatedError(const AdaptationParameters &parameters)
  {
    if (parameters.is_active())
      estimator = create_error_estimator<dim>(parameters);
  }



  template <int dim>
  void
  EstimatedError<dim>::update(ContactProblem<dim>   &problem,
                              const LA::BlockVector &x)
  {
    if (estimator)
      estimate = std::make_unique<const ErrorEstimate>(
        estimate_error(*estimator, problem, x));
  }



  template <int dim>
  void
  EstimatedError<dim>::resume(const Vector<double> &indicators,
                              const double          energy_norm,
                              const MPI_Comm       &communicator)
  {
    estimate = std::make_unique<const ErrorEstimate>(
      estimate_of(indicators, is_of_rule(), energy_norm, communicator));
  }



  template <int dim>
  void
  EstimatedError<dim>::add_to(StatisticsTable &table) const
  {
    if (!estimate || estimate->is_rule)
      return;
    table.add("estimated_error", estimate->error);
    table.add("relative_error", estimate->relative());
  }



  template <int dim>
  NamedCellValues
  EstimatedError<dim>::fields(const Triangulation<dim> &triangulation) const
  {
    if (!estimate)
      return {};
    const Vector<float> none(triangulation.n_active_cells());
    NamedCellValues     fields = {{"error_indicator", none}, {"level", none}};
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int i = cell->active_cell_index();
          fields[0].second[i]  = std::sqrt(estimate->indicators[i]);
          fields[1].second[i]  = cell->level();
        }
    return fields;
  }

  template class EstimatedError<2>;
  template class EstimatedError<3>;
} // namespace stickslip
