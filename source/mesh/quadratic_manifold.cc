#include <stickslip/mesh/quadratic_manifold.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace stickslip
{
  namespace
  {
    template <int dim>
    std::vector<std::pair<BoundingBox<dim>, unsigned int>>
    boxes_of(const QuadraticCells<dim> &cells)
    {
      std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
      for (unsigned int c = 0; c < cells.size(); ++c)
        boxes.emplace_back(cells.box(c), c);
      return boxes;
    }
  } // namespace



  template <int dim>
  QuadraticManifold<dim>::QuadraticManifold(
    const std::shared_ptr<const QuadraticCells<dim>> &cells)
    : cells(cells)
    , boxes(
        std::make_shared<const RTree<BoxOfCell>>(pack_rtree(boxes_of(*cells))))
  {}



  template <int dim>
  std::unique_ptr<Manifold<dim, dim>>
  QuadraticManifold<dim>::clone() const
  {
    return std::make_unique<QuadraticManifold<dim>>(*this);
  }



  template <int dim>
  typename QuadraticManifold<dim>::UnitPoints
  QuadraticManifold<dim>::in_unit_cell(
    const ArrayView<const Point<dim>> &points) const
  {
    namespace bgi = boost::geometry::index;

    const BoundingBox<dim> box(
      std::vector<Point<dim>>(points.begin(), points.end()));
    std::vector<BoxOfCell> candidates;
    boxes->query(bgi::covers(box), std::back_inserter(candidates));
    // The same choice whatever order the tree has.
    std::sort(candidates.begin(),
              candidates.end(),
              [](const BoxOfCell &a, const BoxOfCell &b) {
                return a.second < b.second;
              });
    const auto find_cell =
      [&](const auto &unit_position) -> std::optional<UnitPoints> {
      for (const auto &candidate : candidates)
        {
          UnitPoints found{candidate.second, {}};
          for (const Point<dim> &point : points)
            if (const auto unit = unit_position(found.cell, point))
              found.points.push_back(*unit);
            else
              break;
          if (found.points.size() == points.size())
            return found;
        }
      return {};
    };
    // Sides of the mesh as it was read end at nodes, which is quickly seen.
    if (const auto found = find_cell([&](const std::size_t c, const auto &x) {
          return cells->unit_position_of_node(c, x);
        }))
      return *found;
    if (const auto found = find_cell([&](const std::size_t c, const auto &x) {
          return cells->unit_position(c, x);
        }))
      return *found;
    AssertThrow(false,
                ExcMessage("No curved cell has all points of a side or cell "
                           "of the mesh."));
    return {};
  }



  template <int dim>
  Point<dim>
  QuadraticManifold<dim>::get_new_point(
    const ArrayView<const Point<dim>> &surrounding_points,
    const ArrayView<const double>     &weights) const
  {
    const UnitPoints unit = in_unit_cell(surrounding_points);
    Point<dim>       mean;
    for (unsigned int i = 0; i < weights.size(); ++i)
      mean += weights[i] * Tensor<1, dim>(unit.points[i]);
    return cells->position(unit.cell, mean);
  }



  template <int dim>
  void
  QuadraticManifold<dim>::get_new_points(
    const ArrayView<const Point<dim>> &surrounding_points,
    const Table<2, double>            &weights,
    ArrayView<Point<dim>>              new_points) const
  {
    const UnitPoints unit = in_unit_cell(surrounding_points);
    for (unsigned int p = 0; p < new_points.size(); ++p)
      {
        Point<dim> mean;
        for (unsigned int i = 0; i < unit.points.size(); ++i)
          mean += weights(p, i) * Tensor<1, dim>(unit.points[i]);
        new_points[p] = cells->position(unit.cell, mean);
      }
  }

  template class QuadraticManifold<2>;
  template class QuadraticManifold<3>;
} // namespace stickslip
