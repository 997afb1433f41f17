#include <stickslip/mesh/quadratic_cells.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace stickslip
{
  template <int dim>
  QuadraticCells<dim>::QuadraticCells(const ReferenceCell &cell)
    : fe(make_element<dim>(cell, 2))
  {}



  template <int dim>
  void
  QuadraticCells<dim>::add(const std::vector<Point<dim>> &new_nodes)
  {
    AssertDimension(new_nodes.size(), fe->n_dofs_per_cell());
    nodes.insert(nodes.end(), new_nodes.begin(), new_nodes.end());
  }



  template <int dim>
  void
  QuadraticCells<dim>::transform(
    const std::function<Point<dim>(const Point<dim> &)> &map)
  {
    for (Point<dim> &node : nodes)
      node = map(node);
  }



  template <int dim>
  Point<dim>
  QuadraticCells<dim>::position(const std::size_t cell,
                                const Point<dim> &unit) const
  {
    Point<dim> x;
    for (unsigned int i = 0; i < fe->n_dofs_per_cell(); ++i)
      x += fe->shape_value(i, unit) * Tensor<1, dim>(node(cell, i));
    return x;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  QuadraticCells<dim>::gradients(const Point<dim> &unit) const
  {
    std::vector<Tensor<1, dim>> result;
    for (unsigned int i = 0; i < fe->n_dofs_per_cell(); ++i)
      result.push_back(fe->shape_grad(i, unit));
    return result;
  }



  template <int dim>
  Tensor<2, dim>
  QuadraticCells<dim>::jacobian(
    const std::size_t                  cell,
    const std::vector<Tensor<1, dim>> &gradients) const
  {
    Tensor<2, dim> result;
    for (unsigned int i = 0; i < fe->n_dofs_per_cell(); ++i)
      result += outer_product(Tensor<1, dim>(node(cell, i)), gradients[i]);
    return result;
  }



  template <int dim>
  std::optional<Point<dim>>
  QuadraticCells<dim>::unit_position_of_node(const std::size_t cell,
                                             const Point<dim> &x) const
  {
    // Far above the roundoff of moved bodies, far below any refinement.
    constexpr double distance_to_node = 1e-10; // of the cell's size

    const unsigned int nearest = nearest_node(cell, x);
    const double       size    = node(cell, 0).distance(node(cell, 1));
    if (x.distance(node(cell, nearest)) < distance_to_node * size)
      return fe->unit_support_point(nearest);
    return {};
  }



  template <int dim>
  unsigned int
  QuadraticCells<dim>::nearest_node(const std::size_t cell,
                                    const Point<dim> &x) const
  {
    unsigned int nearest = 0;
    for (unsigned int i = 1; i < fe->n_dofs_per_cell(); ++i)
      if (x.distance_square(node(cell, i)) <
          x.distance_square(node(cell, nearest)))
        nearest = i;
    return nearest;
  }



  template <int dim>
  std::optional<Point<dim>>
  QuadraticCells<dim>::unit_position(const std::size_t cell,
                                     const Point<dim> &x) const
  {
    if (const auto unit = unit_position_of_node(cell, x))
      return unit;
    for (const Point<dim> &start :
         {fe->unit_support_point(nearest_node(cell, x)),
          fe->reference_cell().template barycenter<dim>()})
      if (const auto unit = unit_position_from(cell, x, start))
        return unit;
    return {};
  }



  template <int dim>
  std::optional<Point<dim>>
  QuadraticCells<dim>::unit_position_from(const std::size_t cell,
                                          const Point<dim> &x,
                                          const Point<dim> &start) const
  {
    constexpr unsigned int most_iterations = 20;
    constexpr double       smallest_step   = 1e-12;
    constexpr double       far_away        = 2.;
    constexpr double       outside         = 1e-6; // room for roundoff

    Point<dim> unit = start;
    for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
      {
        const Tensor<2, dim> inverse = invert(jacobian(cell, gradients(unit)));
        const Tensor<1, dim> step    = inverse * (x - position(cell, unit));
        // the cell may be far from the origin
        const double roundoff = 8. * std::numeric_limits<double>::epsilon() *
                                x.norm() * inverse.norm();
        unit += step;
        // also if it is no number, where the Jacobian is singular
        if (!(distance_to_unit_cell(fe->reference_cell(), unit) < far_away))
          return {};
        if (step.norm() < smallest_step + roundoff)
          {
            if (distance_to_unit_cell(fe->reference_cell(), unit) < outside)
              return unit;
            return {};
          }
      }
    return {};
  }



  template <int dim>
  BoundingBox<dim>
  QuadraticCells<dim>::box(const std::size_t cell) const
  {
    // Polynomials of degree 2 leave the range of their nodes by an eighth of it
    // at most in one direction, and by less than half of it in three.
    constexpr double margin = 0.5;

    Point<dim> low = node(cell, 0), high = low;
    for (unsigned int i = 1; i < fe->n_dofs_per_cell(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          low[d]  = std::min(low[d], node(cell, i)[d]);
          high[d] = std::max(high[d], node(cell, i)[d]);
        }
    const Tensor<1, dim> range = high - low;
    return BoundingBox<dim>(
      std::make_pair(low - margin * range, high + margin * range));
  }

  template class QuadraticCells<2>;
  template class QuadraticCells<3>;
} // namespace stickslip
