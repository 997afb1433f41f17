#include <stickslip/simulation/failed_step.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace stickslip
{
  namespace
  {
    template <int dim>
    std::string
    text_of(const Point<dim> &point)
    {
      std::ostringstream text;
      text.precision(4);
      for (unsigned int d = 0; d < dim; ++d)
        text << (d == 0 ? "(" : ", ") << point[d];
      return text.str() + ")";
    }
  } // namespace



  template <int dim>
  PointGroup<dim>
  find_group(
    const FailedStep<dim>                                  &step,
    const std::function<bool(const PointDiagnosis<dim> &)> &has_property,
    const MPI_Comm                                          communicator)
  {
    std::vector<unsigned int> n_local(step.pairs.size(), 0), n(n_local);
    for (const auto &point : step.points)
      n_local[point.pair] += has_property(point);
    Utilities::MPI::sum(n_local, communicator, n);
    PointGroup<dim> group;
    for (unsigned int p = 0; p < n.size(); ++p)
      {
        group.n += n[p];
        if (n[p] > group.n_pair)
          {
            group.n_pair = n[p];
            group.pair   = p;
          }
      }
    constexpr double    far = std::numeric_limits<double>::max();
    std::vector<double> extent(2 * dim, far); // x, -x
    for (const auto &point : step.points)
      if (point.pair == group.pair && has_property(point))
        for (unsigned int d = 0; d < dim; ++d)
          {
            extent[d]       = std::min(extent[d], point.position[d]);
            extent[dim + d] = std::min(extent[dim + d], -point.position[d]);
          }
    const std::vector<double> of_rank = extent;
    Utilities::MPI::min(of_rank, communicator, extent);
    for (unsigned int d = 0; d < dim; ++d)
      {
        group.lower[d] = extent[d];
        group.upper[d] = -extent[dim + d];
      }
    return group;
  }



  template <int dim>
  std::string
  describe(const PointGroup<dim> &group, const FailedStep<dim> &step)
  {
    std::string text = std::to_string(group.n_pair) +
                       (group.n_pair == 1 ? " point" : " points") +
                       " of pair '" + step.pairs[group.pair].first + "', ";
    if (group.lower.distance(group.upper) == 0.)
      text += "at " + text_of(group.lower);
    else
      text +=
        "between " + text_of(group.lower) + " and " + text_of(group.upper);
    if (group.n > group.n_pair)
      text +=
        "; " + std::to_string(group.n - group.n_pair) + " more of other pairs";
    return text + ".";
  }

#define INSTANTIATE(dim)                                      \
  template PointGroup<dim> find_group(                        \
    const FailedStep<dim> &,                                  \
    const std::function<bool(const PointDiagnosis<dim> &)> &, \
    const MPI_Comm);                                          \
  template std::string describe(const PointGroup<dim> &,      \
                                const FailedStep<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
