#include <stickslip/solid/coupling_masters.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Distances below this fraction of the largest are roundoff.
    constexpr double no_distance = 1e-10;

    /// Rows that are as far as another up to this are taken in their order,
    /// whatever the rounding.
    constexpr double same_distance = 1e-6;



    /// To the neighbours of a cell in a grid, but slightly off them: on a
    /// plane side one of its nodes is the outermost.
    template <int dim>
    std::vector<Tensor<1, dim>>
    search_directions()
    {
      const std::array<double, 3> off = {{0.0131, 0.0317, 0.0229}};
      std::vector<Tensor<1, dim>> directions;
      for (unsigned int i = 0; i < (dim == 2 ? 9u : 27u); ++i)
        {
          Tensor<1, dim> direction;
          unsigned int   digits = i;
          for (unsigned int d = 0; d < dim; ++d, digits /= 3)
            direction[d] = static_cast<double>(digits % 3) - 1.;
          if (direction.norm() == 0.)
            continue;
          for (unsigned int d = 0; d < dim; ++d)
            direction[d] += off[d];
          directions.push_back(direction);
        }
      return directions;
    }



    template <int dim>
    std::vector<MasterCandidate<dim>>
    outermost(const std::vector<MasterCandidate<dim>> &nodes)
    {
      std::vector<MasterCandidate<dim>> result;
      for (const Tensor<1, dim> &direction : search_directions<dim>())
        {
          const MasterCandidate<dim> *best = nullptr;
          for (const auto &node : nodes)
            if (best == nullptr || node.arm * direction > best->arm * direction)
              best = &node;
          if (best != nullptr && std::none_of(result.begin(),
                                              result.end(),
                                              [&](const auto &known) {
                                                return known.dofs == best->dofs;
                                              }))
            result.push_back(*best);
        }
      return result;
    }



    /// Takes its part along @p unit from @p row.
    void
    project_out(const Vector<double> &unit, Vector<double> &row)
    {
      row.add(-(unit * row), unit);
    }



    std::vector<Vector<double>>
    rows_of(const FullMatrix<double> &map)
    {
      std::vector<Vector<double>> rows(map.m(), Vector<double>(map.n()));
      for (unsigned int r = 0; r < map.m(); ++r)
        for (unsigned int c = 0; c < map.n(); ++c)
          rows[r](c) = map(r, c);
      return rows;
    }
  } // namespace



  template <int dim>
  std::vector<MasterCandidate<dim>>
  outermost_nodes(const std::vector<MasterCandidate<dim>> &nodes,
                  const MPI_Comm                           communicator)
  {
    std::vector<MasterCandidate<dim>> all;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator, outermost(nodes)))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    return outermost(all);
  }



  std::vector<unsigned int>
  independent_rows(const FullMatrix<double> &map)
  {
    std::vector<Vector<double>> rows = rows_of(map);
    std::vector<unsigned int>   chosen;
    double                      first = 0.;
    while (chosen.size() < map.n())
      {
        double largest = 0.;
        for (const auto &row : rows)
          largest = std::max<double>(largest, row.l2_norm());
        first = std::max(first, largest);
        if (largest <= no_distance * first)
          return chosen;
        unsigned int r = 0;
        while (rows[r].l2_norm() < (1. - same_distance) * largest)
          ++r;
        chosen.push_back(r);
        Vector<double> unit(rows[r]);
        unit /= unit.l2_norm();
        for (auto &row : rows)
          project_out(unit, row);
      }
    return chosen;
  }



  double
  independence_of(const std::vector<unsigned int> &rows,
                  const FullMatrix<double>        &map)
  {
    if (rows.size() < map.n())
      return 0.;
    const auto                  all   = rows_of(map);
    double                      least = std::numeric_limits<double>::max();
    std::vector<Vector<double>> units;
    for (const unsigned int r : rows)
      {
        Vector<double> row(all[r]);
        for (const auto &unit : units)
          project_out(unit, row);
        const double distance = row.l2_norm();
        least                 = std::min(least, distance);
        if (distance == 0.)
          return 0.;
        row /= distance;
        units.push_back(row);
      }
    return least;
  }



  template std::vector<MasterCandidate<2>>
  outermost_nodes(const std::vector<MasterCandidate<2>> &, const MPI_Comm);
  template std::vector<MasterCandidate<3>>
  outermost_nodes(const std::vector<MasterCandidate<3>> &, const MPI_Comm);
} // namespace stickslip
