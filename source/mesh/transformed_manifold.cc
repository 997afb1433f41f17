#include <stickslip/mesh/transformed_manifold.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Rodrigues' formula; in 2D the axis is z.
    template <int dim>
    Tensor<2, dim>
    body_rotation(const Tensor<1, 3> &axis, const double angle)
    {
      Tensor<1, 3> n;
      n[2] = 1.;
      if (dim == 3 && axis.norm() > 0.)
        n = axis / axis.norm();

      Tensor<2, 3> cross;
      cross[0][1] = -n[2];
      cross[1][0] = n[2];
      cross[0][2] = n[1];
      cross[2][0] = -n[1];
      cross[1][2] = -n[0];
      cross[2][1] = n[0];

      const Tensor<2, 3> rotation = Tensor<2, 3>(unit_symmetric_tensor<3>()) +
                                    std::sin(angle) * cross +
                                    (1. - std::cos(angle)) * (cross * cross);

      Tensor<2, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          result[i][j] = rotation[i][j];
      return result;
    }
  } // namespace



  template <int dim>
  AffineMap<dim>
  AffineMap<dim>::from_motion(const Tensor<1, dim> &scale,
                              const Tensor<1, 3>   &axis,
                              const double          angle,
                              const Tensor<1, dim> &centre,
                              const Tensor<1, dim> &translation)
  {
    Tensor<2, dim> rotation = unit_symmetric_tensor<dim>();
    if (angle != 0.)
      rotation = body_rotation<dim>(axis, angle);

    AffineMap<dim> map;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        map.linear[i][j] = rotation[i][j] * scale[j];
    map.shift = translation;
    if (angle != 0.)
      map.shift += centre - rotation * centre;
    return map;
  }



  template <int dim>
  TransformedManifold<dim>::TransformedManifold(
    std::unique_ptr<Manifold<dim, dim>> original,
    const AffineMap<dim>               &map)
    : original(std::move(original))
    , map(map)
    , inverse(invert(map.linear))
  {}



  template <int dim>
  std::unique_ptr<Manifold<dim, dim>>
  TransformedManifold<dim>::clone() const
  {
    return std::make_unique<TransformedManifold<dim>>(original->clone(), map);
  }



  template <int dim>
  Point<dim>
  TransformedManifold<dim>::pull_back(const Point<dim> &x) const
  {
    return Point<dim>(inverse * (x - map.shift));
  }



  template <int dim>
  std::vector<Point<dim>>
  TransformedManifold<dim>::pull_back(
    const ArrayView<const Point<dim>> &points) const
  {
    std::vector<Point<dim>> result;
    result.reserve(points.size());
    for (const Point<dim> &point : points)
      result.push_back(pull_back(point));
    return result;
  }



  template <int dim>
  Point<dim>
  TransformedManifold<dim>::get_intermediate_point(const Point<dim> &p1,
                                                   const Point<dim> &p2,
                                                   const double      w) const
  {
    return map(
      original->get_intermediate_point(pull_back(p1), pull_back(p2), w));
  }



  template <int dim>
  Point<dim>
  TransformedManifold<dim>::get_new_point(
    const ArrayView<const Point<dim>> &surrounding_points,
    const ArrayView<const double>     &weights) const
  {
    const std::vector<Point<dim>> points = pull_back(surrounding_points);
    return map(original->get_new_point(make_array_view(points), weights));
  }



  template <int dim>
  void
  TransformedManifold<dim>::get_new_points(
    const ArrayView<const Point<dim>> &surrounding_points,
    const Table<2, double>            &weights,
    ArrayView<Point<dim>>              new_points) const
  {
    // The caller may pass overlapping views, so the result gets its own place.
    const std::vector<Point<dim>> points = pull_back(surrounding_points);
    std::vector<Point<dim>>       result(new_points.size());
    original->get_new_points(make_array_view(points),
                             weights,
                             make_array_view(result));
    for (unsigned int i = 0; i < result.size(); ++i)
      new_points[i] = map(result[i]);
  }



  template <int dim>
  Point<dim>
  TransformedManifold<dim>::project_to_manifold(
    const ArrayView<const Point<dim>> &surrounding_points,
    const Point<dim>                  &candidate) const
  {
    const std::vector<Point<dim>> points = pull_back(surrounding_points);
    return map(original->project_to_manifold(make_array_view(points),
                                             pull_back(candidate)));
  }



  template <int dim>
  Tensor<1, dim>
  TransformedManifold<dim>::get_tangent_vector(const Point<dim> &x1,
                                               const Point<dim> &x2) const
  {
    return map.linear *
           original->get_tangent_vector(pull_back(x1), pull_back(x2));
  }



  template struct AffineMap<2>;
  template struct AffineMap<3>;
  template class TransformedManifold<2>;
  template class TransformedManifold<3>;
} // namespace stickslip
