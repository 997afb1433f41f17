#include <stickslip/solid/point_history.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace stickslip
{
  void
  PointHistory::reinit(const std::vector<unsigned int> &n_variables_per_cell,
                       const std::vector<unsigned int> &n_points)
  {
    n_variables = n_variables_per_cell;
    first.assign(n_variables.size() + 1, 0);
    for (std::size_t c = 0; c < n_variables.size(); ++c)
      first[c + 1] = first[c] + n_points[c] * n_variables[c];
    accepted_values.assign(first.back(), 0.);
    trial_values.assign(first.back(), 0.);
  }



  dealii::ArrayView<const double>
  PointHistory::accepted(const unsigned int cell,
                         const unsigned int point) const
  {
    Assert((point + 1) * n_variables[cell] <= first[cell + 1] - first[cell],
           dealii::ExcInternalError());
    return {accepted_values.data() + first[cell] + point * n_variables[cell],
            n_variables[cell]};
  }



  dealii::ArrayView<double>
  PointHistory::trial(const unsigned int cell, const unsigned int point)
  {
    Assert((point + 1) * n_variables[cell] <= first[cell + 1] - first[cell],
           dealii::ExcInternalError());
    return {trial_values.data() + first[cell] + point * n_variables[cell],
            n_variables[cell]};
  }



  dealii::ArrayView<const double>
  PointHistory::accepted_of_cell(const unsigned int cell) const
  {
    return {accepted_values.data() + first[cell],
            first[cell + 1] - first[cell]};
  }



  void
  PointHistory::set_cell(const unsigned int                     cell,
                         const dealii::ArrayView<const double> &values)
  {
    AssertDimension(values.size(), first[cell + 1] - first[cell]);
    std::copy(values.begin(),
              values.end(),
              accepted_values.begin() + first[cell]);
    std::copy(values.begin(), values.end(), trial_values.begin() + first[cell]);
  }



  void
  PointHistory::accept()
  {
    accepted_values = trial_values;
  }



  void
  PointHistory::restore()
  {
    trial_values = accepted_values;
  }
} // namespace stickslip
