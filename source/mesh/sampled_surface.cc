#include <stickslip/mesh/sampled_surface.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/array_view.h>

#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>

#include <deal.II/grid/manifold.h>

#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace stickslip
{
  namespace
  {
    constexpr std::size_t most_points = 4'000'000; // 100 MB in 3D



    /// Bilinear (2D: linear) functions of the vertices of a face.
    template <int dim>
    std::vector<double>
    vertex_weights(const std::array<double, 2> &xi)
    {
      if constexpr (dim == 2)
        return {1. - xi[0], xi[0]};
      return {(1. - xi[0]) * (1. - xi[1]),
              xi[0] * (1. - xi[1]),
              (1. - xi[0]) * xi[1],
              xi[0] * xi[1]};
    }



    /// n + 1 points per direction on a face, where its manifold has them.
    template <int dim, typename FaceIterator>
    void
    add_points(const FaceIterator      &face,
               const unsigned int       n,
               std::vector<Point<dim>> &points)
    {
      std::vector<Point<dim>> vertices;
      for (const unsigned int v : face->vertex_indices())
        vertices.push_back(face->vertex(v));
      for (unsigned int j = 0; j <= (dim == 3 ? n : 0); ++j)
        for (unsigned int i = 0; i <= n; ++i)
          {
            const auto weights =
              vertex_weights<dim>({{double(i) / n, double(j) / n}});
            const auto largest =
              std::max_element(weights.begin(), weights.end());
            points.push_back(
              *largest == 1.
                ? vertices[largest - weights.begin()]
                : face->get_manifold().get_new_point(make_array_view(vertices),
                                                     make_array_view(weights)));
          }
    }
  } // namespace



  template <int dim>
  SampledSurface<dim>::SampledSurface(
    const Triangulation<dim>           &triangulation,
    const std::set<types::boundary_id> &boundary_ids,
    const double                        spacing,
    const unsigned int                  finest_level,
    const std::string                  &parameter_path)
  {
    std::vector<Point<dim>> sampled;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && boundary_ids.count(face->boundary_id()) > 0)
          {
            const double n =
              std::min(std::ceil(face->diameter() / spacing),
                       std::ldexp(1., static_cast<int>(finest_level)));
            if (sampled.size() + std::pow(n + 1., dim - 1) > most_points)
              {
                std::ostringstream text;
                text << parameter_path << ": " << 2. * spacing
                     << " is too small for surfaces of this size. Take a "
                        "larger one.";
                throw UserError(text.str());
              }
            add_points<dim>(face, static_cast<unsigned int>(n), sampled);
          }
    points = pack_rtree(sampled);
  }



  template <int dim>
  bool
  SampledSurface<dim>::is_within(const double            distance,
                                 const BoundingBox<dim> &box) const
  {
    namespace bgi                    = boost::geometry::index;
    BoundingBox<dim> around          = box;
    const auto       is_near_the_box = [&](const Point<dim> &p) {
      double square = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        square += std::pow(
          std::max({box.lower_bound(d) - p[d], 0., p[d] - box.upper_bound(d)}),
          2);
      return square <= distance * distance;
    };
    around.extend(distance);
    return points.qbegin(bgi::intersects(around) &&
                         bgi::satisfies(is_near_the_box)) != points.qend();
  }

  template class SampledSurface<2>;
  template class SampledSurface<3>;
} // namespace stickslip
