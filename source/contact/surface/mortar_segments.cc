#include <stickslip/contact/surface/mortar_segments.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace stickslip
{
  namespace
  {
    /// Segments below this fraction of the slave's cell are roundoff.
    constexpr double negligible_segment = 1e-12;



    /// The area of the undeformed body per parametric area where a face with
    /// these nodes has the shape functions @p values.
    template <int dim>
    double
    undeformed_area(const FaceShapeValues<dim>        &values,
                    const std::vector<Tensor<1, dim>> &nodes,
                    const CrossSection                &cross_section)
    {
      return surface_normal<dim>(surface_tangents<dim>(values.gradient, nodes))
               .norm() *
             cross_section.circumference(interpolate<dim>(values.value, nodes));
    }



    /// True if @p p lies on the edge of @p cell from corner @p i on.
    template <int facedim>
    bool
    is_on_edge(const Point<facedim>      &p,
               const ConvexCell<facedim> &cell,
               const unsigned int         i)
    {
      constexpr double tolerance = 1e-10; // of the length of the edge
      if constexpr (facedim == 1)
        return std::abs(p[0] - cell[i][0]) <
               tolerance * std::abs(cell[1][0] - cell[0][0]);
      else
        {
          const Tensor<1, 2> edge = cell[(i + 1) % cell.size()] - cell[i];
          const Tensor<1, 2> way  = p - cell[i];
          return std::abs(edge[0] * way[1] - edge[1] * way[0]) <
                 tolerance * edge.norm_square();
        }
    }



    /// An edge of a polygon (2D: an end of an interval), from the inside.
    template <int facedim>
    struct Border
    {
      Point<facedim>     begin;
      Tensor<1, facedim> way; ///< to its end; zero in 2D
      Tensor<1, facedim> outward;

      Point<facedim>
      at(const double s) const
      {
        return begin + s * way;
      }
    };



    template <int facedim>
    std::vector<Border<facedim>>
    borders_of(const ConvexCell<facedim> &cell)
    {
      std::vector<Border<facedim>> borders;
      Point<facedim>               inside;
      for (const auto &corner : cell)
        inside += Tensor<1, facedim>(corner) / static_cast<double>(cell.size());
      for (unsigned int i = 0; i < cell.size(); ++i)
        {
          Border<facedim> border;
          border.begin = cell[i];
          if constexpr (facedim == 2)
            {
              border.way     = cell[(i + 1) % cell.size()] - cell[i];
              border.outward = Tensor<1, 2>({border.way[1], -border.way[0]});
            }
          else
            border.outward[0] = 1.;
          if (border.outward.norm() == 0.)
            continue;
          border.outward /= border.outward.norm();
          if (border.outward * (border.at(0.5) - inside) < 0.)
            border.outward *= -1.;
          borders.push_back(border);
        }
      return borders;
    }



    /// The edge of @p cell that @p border lies on.
    template <int facedim>
    std::optional<unsigned int>
    edge_below(const Border<facedim> &border, const ConvexCell<facedim> &cell)
    {
      for (unsigned int i = 0; i < cell.size(); ++i)
        if (is_on_edge<facedim>(border.at(0.), cell, i) &&
            is_on_edge<facedim>(border.at(1.), cell, i))
          return i;
      return {};
    }
  } // namespace



  template <int dim>
  SegmentRule<dim>::SegmentRule(const FaceShape<dim> &slave_shape,
                                const FaceShape<dim> &master_shape,
                                const unsigned int    order,
                                const CrossSection   &cross_section)
    : slave_shape(slave_shape)
    , master_shape(master_shape)
    , cross_section(cross_section)
    , quadrature(slave_shape, master_shape, order, cross_section)
    , edge_rule(QGauss<dim - 2>(2 * slave_shape.degree() + 2))
  {}



  template <int dim>
  bool
  SegmentRule<dim>::find_above(const FaceShape<dim>              &shape,
                               const Point<dim - 1>              &p,
                               const ProjectionPlane<dim>        &plane,
                               const std::vector<Tensor<1, dim>> &positions,
                               Point<dim - 1>                    &xi,
                               FaceShapeValues<dim>              &values,
                               double &area_ratio) const
  {
    constexpr unsigned int most_iterations = 20;
    for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
      {
        shape.evaluate_gradients(xi, values);
        const Tensor<1, dim> x = interpolate<dim>(values.value, positions);
        const auto a = surface_tangents<dim>(values.gradient, positions);
        Tensor<2, dim - 1> jacobian;
        for (unsigned int d = 0; d < dim - 1; ++d)
          for (unsigned int c = 0; c < dim - 1; ++c)
            jacobian[d][c] = plane.e[d] * a[c];
        area_ratio = std::abs(determinant(jacobian));
        if (area_ratio == 0.)
          return false;
        const Tensor<1, dim - 1> step =
          invert(jacobian) * (p - plane.coordinates(x));
        xi += step;
        // the face may be far from the origin
        const double roundoff = 4. * std::numeric_limits<double>::epsilon() *
                                Tensor<1, dim>(plane.origin).norm() *
                                invert(jacobian).norm();
        if (step.norm() < 1e-13 + roundoff)
          return true;
        if (step.norm() > 1e3)
          return false;
      }
    return false;
  }



  template <int dim>
  void
  SegmentRule<dim>::add_points(const ProjectionPlane<dim>     &plane,
                               const Side                     &slave,
                               const std::vector<Point<dim>>  &reference,
                               const Side                     &opposite,
                               const unsigned int              master,
                               std::vector<SegmentPoint<dim>> &points) const
  {
    const std::vector<Tensor<1, dim>> undeformed(reference.begin(),
                                                 reference.begin() +
                                                   slave_shape.n_nodes());
    FaceShapeValues<dim>              values, master_values;
    double                            area_ratio, master_ratio;
    for (unsigned int i = 0; i < slave.projected.cells.size(); ++i)
      for (unsigned int j = 0; j < opposite.projected.cells.size(); ++j)
        {
          const auto &cell    = slave.projected.cells[i];
          const auto  overlap = simplices<dim - 1>(
            intersection<dim - 1>(cell, opposite.projected.cells[j]));
          if (overlap.empty())
            continue;
          const Quadrature<dim - 1> &rule =
            quadrature.rule(slave.projected, i, opposite.projected, j);
          const double smallest = negligible_segment * measure<dim - 1>(cell);
          const ParametricMap<dim> on_slave(slave_shape, slave.projected, i);
          const ParametricMap<dim> on_master(master_shape,
                                             opposite.projected,
                                             j);
          const auto               find_on_slave = [&](const Point<dim - 1> &p,
                                         SegmentPoint<dim>    &point) {
            point.xi = on_slave.at(p);
            return find_above(slave_shape,
                              p,
                              plane,
                              slave.positions,
                              point.xi,
                              values,
                              area_ratio);
          };
          for (const auto &simplex : overlap)
            {
              const double area = measure<dim - 1>(simplex);
              if (area <= smallest)
                continue;
              SegmentPoint<dim> begin, end;
              const bool        is_parametric = quadrature.is_parametric();
              if (is_parametric && !(find_on_slave(simplex[0], begin) &&
                                     find_on_slave(simplex[1], end)))
                continue;
              // the rule is for a simplex of measure 1 / (dim-1)!
              const double scale = (dim == 3 ? 2. : 1.) * area;
              for (unsigned int q = 0; q < rule.size(); ++q)
                {
                  SegmentPoint<dim> point;
                  Point<dim - 1>    p = simplex[0];
                  point.master        = master;
                  if (is_parametric)
                    {
                      point.xi =
                        begin.xi + rule.point(q)[0] * (end.xi - begin.xi);
                      slave_shape.evaluate_gradients(point.xi, values);
                      p = plane.coordinates(
                        interpolate<dim>(values.value, slave.positions));
                      point.weight =
                        rule.weight(q) * (end.xi - begin.xi).norm();
                    }
                  else
                    {
                      for (unsigned int d = 0; d < dim - 1; ++d)
                        p += rule.point(q)[d] * (simplex[d + 1] - simplex[0]);
                      if (!find_on_slave(p, point))
                        continue;
                      point.weight = rule.weight(q) * scale / area_ratio;
                    }
                  point.eta = on_master.at(p);
                  if (!find_above(master_shape,
                                  p,
                                  plane,
                                  opposite.positions,
                                  point.eta,
                                  master_values,
                                  master_ratio))
                    continue;
                  point.weight *=
                    undeformed_area(values, undeformed, cross_section);
                  points.push_back(point);
                }
            }
        }
  }



  template <int dim>
  void
  SegmentRule<dim>::add_ends(const ProjectionPlane<dim>    &plane,
                             const Side                    &slave,
                             const std::vector<Point<dim>> &reference,
                             const Side                    &opposite,
                             const unsigned int             master,
                             std::vector<SegmentEnd<dim>>  &ends) const
  {
    const std::vector<Tensor<1, dim>> undeformed(reference.begin(),
                                                 reference.begin() +
                                                   slave_shape.n_nodes());
    FaceShapeValues<dim>              values;
    double                            area_ratio;
    for (unsigned int c = 0; c < slave.projected.cells.size(); ++c)
      for (unsigned int j = 0; j < opposite.projected.cells.size(); ++j)
        {
          const auto &slave_cell  = slave.projected.cells[c];
          const auto &master_cell = opposite.projected.cells[j];
          for (const auto &border : borders_of<dim - 1>(
                 intersection<dim - 1>(slave_cell, master_cell)))
            {
              const auto slave_edge  = edge_below<dim - 1>(border, slave_cell);
              const auto master_edge = edge_below<dim - 1>(border, master_cell);
              const bool on_slave    = slave_edge.has_value();
              if (!(on_slave
                      ? slave.projected.moving_edges[c][*slave_edge]
                      : master_edge.has_value() &&
                          opposite.projected.moving_edges[j][*master_edge]))
                continue;
              const auto &cell    = on_slave ? slave_cell : master_cell;
              const auto &corners = on_slave ? slave_shape.cells()[c].corners
                                             : master_shape.cells()[j].corners;
              const unsigned int edge = on_slave ? *slave_edge : *master_edge;
              const unsigned int next = (edge + 1) % cell.size();
              const ParametricMap<dim> eta(master_shape, opposite.projected, j);
              const ParametricMap<dim> xi(slave_shape, slave.projected, c);
              for (unsigned int q = 0; q < edge_rule.size(); ++q)
                {
                  Point<dim - 1> p      = border.begin;
                  double         length = 1.;
                  if constexpr (dim == 3)
                    {
                      p      = border.at(edge_rule.point(q)[0]);
                      length = border.way.norm();
                    }
                  SegmentEnd<dim> end;
                  end.master   = master;
                  end.on_slave = on_slave;
                  end.nodes    = {{corners[edge], corners[next]}};
                  if constexpr (dim == 3)
                    end.share = (p - cell[edge]).norm() /
                                (cell[next] - cell[edge]).norm();
                  for (unsigned int d = 0; d < dim - 1; ++d)
                    end.outward += border.outward[d] * plane.e[d];
                  end.xi  = xi.at(p);
                  end.eta = eta.at(p);
                  if (!find_above(master_shape,
                                  p,
                                  plane,
                                  opposite.positions,
                                  end.eta,
                                  values,
                                  area_ratio) ||
                      !find_above(slave_shape,
                                  p,
                                  plane,
                                  slave.positions,
                                  end.xi,
                                  values,
                                  area_ratio))
                    continue;
                  end.weight =
                    edge_rule.weight(q) * length / area_ratio *
                    undeformed_area(values, undeformed, cross_section);
                  ends.push_back(end);
                }
            }
        }
  }

#define INSTANTIATE(dim) template class SegmentRule<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
