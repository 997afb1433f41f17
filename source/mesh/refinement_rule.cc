#include <stickslip/mesh/refinement_rule.h>

#include <stickslip/base/in_space.h>
#include <stickslip/base/parsed_expression.h>
#include <stickslip/base/user_error.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Of cells that may be near a tool, to an eighth of them; in 2D a
    /// sixteenth.
    template <int dim>
    constexpr unsigned int halvings_beside_tools = dim == 2 ? 4 : 3;



    template <int dim>
    double
    smallest_coarse_face(const Triangulation<dim>           &triangulation,
                         const std::set<types::boundary_id> &ids)
    {
      double smallest = std::numeric_limits<double>::max();
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
            smallest = std::min(smallest, face->diameter());
      return smallest;
    }



    template <int dim>
    double
    distance_from_box(const BoundingBox<dim>    &box,
                      const std::vector<double> &point)
    {
      double square = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        square += std::pow(std::max({box.lower_bound(d) - point[d],
                                     0.,
                                     point[d] - box.upper_bound(d)}),
                           2);
      return std::sqrt(square);
    }



    template <int dim, typename CellIterator>
    std::vector<Point<dim>>
    vertices_and_centre(const CellIterator &cell)
    {
      std::vector<Point<dim>> points(1, cell->center());
      for (const unsigned int v : cell->vertex_indices())
        points.push_back(cell->vertex(v));
      return points;
    }



    /// Around the cell as it is on its manifolds: a coarse cell of a ball
    /// reaches far beyond its vertices.
    template <int dim, typename CellIterator>
    BoundingBox<dim>
    curved_box(const CellIterator &cell)
    {
      std::vector<Point<dim>> points     = vertices_and_centre<dim>(cell);
      const auto              add_centre = [&points](const auto &object) {
        if (object->manifold_id() != numbers::flat_manifold_id)
          points.push_back(object->center(/*respect_manifold=*/true));
      };
      for (const auto &face : cell->face_iterators())
        add_centre(face);
      if constexpr (dim == 3)
        for (const unsigned int l : cell->line_indices())
          add_centre(cell->line(l));
      return BoundingBox<dim>(points);
    }



    /// Whether a part of @p box is within @p distance of what has
    /// @p distance_from; it is halved that often to find out.
    template <int dim>
    bool
    is_within(const BoundingBox<dim>                        &box,
              const double                                   distance,
              const std::function<double(const Point<3> &)> &distance_from,
              const unsigned int                             halvings)
    {
      const Point<dim> low   = box.get_boundary_points().first;
      const Point<dim> high  = box.get_boundary_points().second;
      const double     reach = 0.5 * low.distance(high);
      const double     middle =
        distance_from(Point<3>(in_space<dim>(Tensor<1, dim>(box.center()))));
      if (middle <= distance)
        return true;
      // where the surface has ended the distance is not known
      const bool may_be = !std::isfinite(middle) || middle - reach <= distance;
      if (halvings == 0 || reach == 0. || !may_be)
        return may_be && std::isfinite(middle) && reach > 0.;
      for (unsigned int part = 0; part < (1U << dim); ++part)
        {
          Point<dim> corner = low, opposite = box.center();
          for (unsigned int d = 0; d < dim; ++d)
            if ((part >> d) & 1U)
              {
                corner[d]   = box.center()[d];
                opposite[d] = high[d];
              }
          if (is_within(BoundingBox<dim>({corner, opposite}),
                        distance,
                        distance_from,
                        halvings - 1))
            return true;
        }
      return false;
    }



    template <int dim>
    bool
    holds_at(const FunctionParser<3> &condition, const Point<dim> &p)
    {
      Point<3> position;
      for (unsigned int d = 0; d < dim; ++d)
        position[d] = p[d];
      return condition.value(position) != 0.;
    }
  } // namespace



  template <int dim>
  RefinementRule<dim>::RefinementRule(const RefinementRequest  &request,
                                      const Bodies             &bodies,
                                      const Triangulation<dim> &triangulation,
                                      const unsigned int        n_global)
    : request(request)
    , bodies(&bodies)
  {
    const RefinementParameters &parameters = request.parameters;
    for (const std::string &name : parameters.bodies)
      of_bodies.insert(bodies.index_of(name, request.path + "/Body"));
    if (parameters.type == RefinementType::condition)
      condition = parse_expressions<3>("x,y,z",
                                       {parameters.condition},
                                       request.path + "/Condition");

    const unsigned int finest = n_global + parameters.levels;
    const auto         ids_of = [&bodies](const NamedSurface &surface) {
      return bodies.global_boundary_ids(surface.body,
                                        surface.boundary,
                                        surface.parameter_path);
    };
    // @p own: in a body that touches itself, only cells on this surface
    const auto add_vicinity = [&](const std::string                  &body,
                                  const auto                         &ids,
                                  const std::set<types::boundary_id> &own) {
      // half of what has to be told apart: the distance, or the finest cells
      const double spacing =
        0.5 * std::max(parameters.distance,
                       std::ldexp(smallest_coarse_face(triangulation, ids),
                                  -static_cast<int>(finest)));
      vicinities.push_back(
        {bodies.index_of(body, request.path),
         SampledSurface<dim>(
           triangulation, ids, spacing, finest + 1, request.path + "/Distance"),
         own});
    };
    if (parameters.type == RefinementType::boundary)
      {
        const NamedSurface surface{request.path + "/Boundary",
                                   parameters.bodies.front(),
                                   parameters.boundary};
        add_vicinity(surface.body, ids_of(surface), {});
      }
    if (request.distance_from_tool)
      beside_tool = bodies.index_of(request.slave.body, request.path);
    else if (parameters.type == RefinementType::contact)
      {
        const auto slave   = ids_of(request.slave);
        const auto master  = ids_of(request.master);
        const bool is_self = request.slave.body == request.master.body;
        const std::set<types::boundary_id> all;
        add_vicinity(request.slave.body, master, is_self ? slave : all);
        add_vicinity(request.master.body, slave, is_self ? master : all);
      }
  }



  template <int dim>
  bool
  RefinementRule<dim>::meets(const CellIterator     &cell,
                             const BoundingBox<dim> &box) const
  {
    const RefinementParameters &parameters = request.parameters;
    const unsigned int          body = bodies->body_of(cell->material_id());
    const auto is_on = [&cell](const std::set<types::boundary_id> &ids) {
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
          return true;
      return ids.empty();
    };
    bool is_inside = true;
    switch (parameters.type)
      {
        case RefinementType::box:
          for (unsigned int d = 0; d < dim; ++d)
            is_inside = is_inside &&
                        box.lower_bound(d) < parameters.second_corner[d] &&
                        box.upper_bound(d) > parameters.first_corner[d];
          return is_inside;
        case RefinementType::sphere:
          return distance_from_box(box, parameters.centre) < parameters.radius;
        case RefinementType::condition:
          return holds_at(*condition, box.center());
        case RefinementType::boundary:
        case RefinementType::contact:
          if (request.distance_from_tool)
            return body == beside_tool && is_within(box,
                                                    parameters.distance,
                                                    request.distance_from_tool,
                                                    halvings_beside_tools<dim>);
          return std::any_of(
            vicinities.begin(),
            vicinities.end(),
            [&](const Vicinity &vicinity) {
              return vicinity.body == body && is_on(vicinity.own) &&
                     vicinity.surface.is_within(parameters.distance, box);
            });
      }
    return false;
  }



  template <int dim>
  bool
  RefinementRule<dim>::concerns_body(const CellIterator &cell) const
  {
    return of_bodies.empty() ||
           of_bodies.count(bodies->body_of(cell->material_id())) > 0;
  }



  template <int dim>
  bool
  RefinementRule<dim>::concerns(const CellIterator &cell) const
  {
    if (!concerns_body(cell))
      return false;
    if (request.parameters.type != RefinementType::condition)
      return meets(cell, curved_box<dim>(cell));
    const auto points = vertices_and_centre<dim>(cell);
    return std::any_of(points.begin(), points.end(), [&](const Point<dim> &p) {
      return meets(cell, BoundingBox<dim>({p, p}));
    });
  }



  template <int dim>
  bool
  RefinementRule<dim>::covers(const CellIterator &cell) const
  {
    const auto points = vertices_and_centre<dim>(cell);
    return concerns_body(cell) &&
           std::all_of(points.begin(), points.end(), [&](const Point<dim> &p) {
             return meets(cell, BoundingBox<dim>({p, p}));
           });
  }

  template class RefinementRule<2>;
  template class RefinementRule<3>;
} // namespace stickslip
