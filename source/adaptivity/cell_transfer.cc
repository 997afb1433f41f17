#include <stickslip/adaptivity/cell_transfer.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    template <int dim>
    unsigned int
    nearest_point(const Quadrature<dim> &quadrature, const Point<dim> &place)
    {
      const auto &points  = quadrature.get_points();
      const auto  nearest = std::min_element(
        points.begin(), points.end(), [&place](const auto &a, const auto &b) {
          return a.distance_square(place) < b.distance_square(place);
        });
      return nearest - points.begin();
    }



    /// The variables of point @p q of @p n_points.
    void
    append_point(const std::vector<double> &history,
                 const unsigned int         q,
                 const unsigned int         n_points,
                 std::vector<double>       &to)
    {
      const std::size_t n = history.size() / n_points;
      to.insert(to.end(),
                history.begin() + q * n,
                history.begin() + (q + 1) * n);
    }
  } // namespace



  template <int dim>
  CellTransfer<dim>::CellTransfer(const FiniteElement<dim> &element,
                                  const Quadrature<dim>    &quadrature)
    : element(element)
    , n_points(quadrature.size())
    , smooth_decrease(Utilities::fixed_power<2>(1. / (1 << element.degree)))
  {
    using Cell = GeometryInfo<dim>;
    nearest_of_parent.resize(Cell::max_children_per_cell);
    for (unsigned int child = 0; child < nearest_of_parent.size(); ++child)
      for (const Point<dim> &point : quadrature.get_points())
        nearest_of_parent[child].push_back(
          nearest_point(quadrature,
                        Cell::child_to_cell_coordinates(point, child)));
    for (const Point<dim> &point : quadrature.get_points())
      {
        const unsigned int child = Cell::child_cell_from_point(point);
        nearest_of_children.push_back(
          {child,
           nearest_point(quadrature,
                         Cell::cell_to_child_coordinates(point, child))});
      }
  }



  template <int dim>
  CellRecord::NodalField
  CellTransfer<dim>::on_child(const CellRecord::NodalField &parent,
                              const unsigned int            child) const
  {
    const auto        &prolongation = element.get_prolongation_matrix(child);
    const unsigned int n            = element.n_dofs_per_cell();
    CellRecord::NodalField values(parent.size(), 0.);
    for (std::size_t first = 0; first < parent.size(); first += n)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          values[first + i] += prolongation(i, j) * parent[first + j];
    return values;
  }



  template <int dim>
  void
  CellTransfer<dim>::take_from(const CellRecord::NodalField &child_values,
                               const unsigned int            child,
                               CellRecord::NodalField       &parent) const
  {
    const auto        &restriction = element.get_restriction_matrix(child);
    const unsigned int n           = element.n_dofs_per_cell();
    for (unsigned int i = 0; i < n; ++i)
      {
        bool is_in_child = false;
        for (unsigned int j = 0; j < n; ++j)
          is_in_child = is_in_child || restriction(i, j) != 0.;
        if (!is_in_child)
          continue;
        for (std::size_t first = 0; first < parent.size(); first += n)
          {
            parent[first + i] = 0.;
            for (unsigned int j = 0; j < n; ++j)
              parent[first + i] += restriction(i, j) * child_values[first + j];
          }
      }
  }



  template <int dim>
  std::vector<CellRecord>
  CellTransfer<dim>::to_children(const CellRecord &parent) const
  {
    std::vector<CellRecord> children(nearest_of_parent.size());
    for (unsigned int child = 0; child < children.size(); ++child)
      {
        CellRecord &record = children[child];
        record.in_body     = on_child(parent.in_body, child);
        record.indicator = smooth_decrease * parent.indicator / children.size();
        for (const unsigned int q : nearest_of_parent[child])
          append_point(parent.history, q, n_points, record.history);
        for (const auto &surface : parent.on_surfaces)
          record.on_surfaces.push_back(
            {surface.pair, on_child(surface.values, child)});
      }
    return children;
  }



  template <int dim>
  CellRecord
  CellTransfer<dim>::to_parent(const std::vector<CellRecord> &children) const
  {
    CellRecord parent;
    parent.in_body.resize(children.front().in_body.size(), 0.);
    for (const auto &[child, point] : nearest_of_children)
      append_point(children[child].history, point, n_points, parent.history);
    for (unsigned int child = 0; child < children.size(); ++child)
      {
        take_from(children[child].in_body, child, parent.in_body);
        parent.indicator += children[child].indicator;
        // a child without a face on the surface knows nothing of its nodes
        for (const auto &surface : children[child].on_surfaces)
          {
            auto &surfaces = parent.on_surfaces;
            auto  found    = std::find_if(surfaces.begin(),
                                      surfaces.end(),
                                      [&surface](const auto &other) {
                                        return other.pair == surface.pair;
                                      });
            if (found == surfaces.end())
              found =
                surfaces.insert(surfaces.end(),
                                {surface.pair,
                                 CellRecord::NodalField(surface.values.size(),
                                                        0.)});
            take_from(surface.values, child, found->values);
          }
      }
    return parent;
  }

  template class CellTransfer<2>;
  template class CellTransfer<3>;
} // namespace stickslip
