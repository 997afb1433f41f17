#include <stickslip/mesh/periodic_nodes.h>

#include <stickslip/base/user_error.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Places that differ by less, as a part of the size of a cell, are the
    /// same.
    constexpr double same_place = 1e-5;

    /// A place of a node, with the size of a cell there.
    template <int dim>
    struct Place
    {
      Point<dim> x;
      double     size = 0.;
    };

    /// By first dof.
    template <int dim>
    using Places = std::map<types::global_dof_index, Place<dim>>;



    /// Of the nodes of the cells in sight on @p boundary.
    template <int dim>
    Places<dim>
    places_on(const types::boundary_id          boundary,
              const hp::MappingCollection<dim> &mapping,
              const DoFHandler<dim>            &dof_handler)
    {
      Places<dim>                          places;
      std::vector<types::global_dof_index> dofs;
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          if (cell->is_artificial() || !cell->at_boundary())
            continue;
          const FiniteElement<dim> &fe = cell->get_fe();
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f) &&
                cell->face(f)->boundary_id() == boundary)
              {
                dofs.resize(fe.n_dofs_per_cell());
                cell->get_dof_indices(dofs);
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  if (fe.system_to_component_index(i).first == 0 &&
                      fe.has_support_on_face(i, f))
                    places[dofs[i]] = {
                      mapping[cell->active_fe_index()]
                        .transform_unit_to_real_cell(
                          typename Triangulation<dim>::cell_iterator(cell),
                          fe.unit_support_point(i)),
                      cell->diameter()};
              }
        }
      return places;
    }



    /// A node, and the same node on the other side of a boundary.
    struct Step
    {
      types::global_dof_index there;
      unsigned int            boundary;
      bool                    forward; ///< from the first to the second
    };



    /// By first dof. @p error: what to say where an owned node has no match.
    template <int dim>
    std::map<types::global_dof_index, std::vector<Step>>
    steps_between(const std::vector<PeriodicBoundary> &boundaries,
                  const hp::MappingCollection<dim>    &mapping,
                  const DoFHandler<dim>               &dof_handler,
                  std::string                         &error)
    {
      std::map<types::global_dof_index, std::vector<Step>> steps;
      for (unsigned int b = 0; b < boundaries.size(); ++b)
        {
          const auto first =
            places_on(boundaries[b].first, mapping, dof_handler);
          const auto second =
            places_on(boundaries[b].second, mapping, dof_handler);
          std::vector<std::pair<Point<dim>, types::global_dof_index>> points;
          for (const auto &[dof, place] : second)
            points.emplace_back(place.x, dof);
          const auto tree = pack_rtree(points);
          for (const auto &[dof, place] : first)
            {
              const Point<dim> x(boundaries[b].motion(Tensor<1, dim>(place.x)));
              bool             is_matched = false;
              for (const auto &hit :
                   tree | boost::geometry::index::adaptors::queried(
                            boost::geometry::index::nearest(x, 1)))
                if (hit.first.distance(x) < same_place * place.size)
                  {
                    is_matched = true;
                    steps[dof].push_back({hit.second, b, true});
                    steps[hit.second].push_back({dof, b, false});
                  }
              if (!is_matched &&
                  dof_handler.locally_owned_dofs().is_element(dof))
                error = boundaries[b].parameter_path +
                        ": the coarse cells on both boundaries match, but "
                        "nodes of the finer ones do not: their curved sides "
                        "are not images of each other.";
            }
        }
      return steps;
    }



    /// How often each boundary is passed on the way from an original: 0, 1, -1.
    using Way = std::vector<int>;



    PeriodicMotion
    motion_along(const Way                           &way,
                 const std::vector<PeriodicBoundary> &boundaries)
    {
      PeriodicMotion motion;
      for (unsigned int b = 0; b < way.size(); ++b)
        if (way[b] != 0)
          motion =
            (way[b] > 0 ? boundaries[b].motion : boundaries[b].motion.inverse())
              .after(motion);
      return motion;
    }



    /// The places of the node at @p start, with the ways there.
    std::map<types::global_dof_index, Way>
    ways_from(const types::global_dof_index                               start,
              const std::map<types::global_dof_index, std::vector<Step>> &steps,
              const unsigned int n_boundaries)
    {
      std::map<types::global_dof_index, Way> ways;
      ways[start]                               = Way(n_boundaries, 0);
      std::vector<types::global_dof_index> todo = {start};
      while (!todo.empty())
        {
          const auto here = todo.back();
          todo.pop_back();
          for (const Step &step : steps.at(here))
            {
              Way way = ways.at(here);
              way[step.boundary] += step.forward ? 1 : -1;
              if (ways.emplace(step.there, way).second)
                todo.push_back(step.there);
            }
        }
      return ways;
    }
  } // namespace



  template <int dim>
  PeriodicNodes<dim>::PeriodicNodes(
    const std::vector<PeriodicBoundary> &boundaries,
    const hp::MappingCollection<dim>    &mapping,
    const DoFHandler<dim>               &dof_handler)
  {
    is_periodic = !boundaries.empty();
    if (!is_periodic)
      return;
    const IndexSet &owned = dof_handler.locally_owned_dofs();
    IndexSet        relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);

    // Owners see all places of a node; who has one at the rim of the ghost
    // cells may not. What they say: original + 1, and the way from there.
    const MPI_Comm          communicator = dof_handler.get_communicator();
    LA::Vector              original_of(owned, communicator);
    std::vector<LA::Vector> way_of(boundaries.size(), original_of);
    std::string             error;
    const auto steps = steps_between(boundaries, mapping, dof_handler, error);
    throw_collectively(error, communicator);
    std::set<types::global_dof_index> done;
    for (const auto &entry : steps)
      {
        if (done.count(entry.first) > 0)
          continue;
        // the smallest dof of all places comes first
        for (const auto &[dof, way] :
             ways_from(entry.first, steps, boundaries.size()))
          {
            done.insert(dof);
            if (dof == entry.first || !owned.is_element(dof))
              continue;
            original_of(dof) = 1. + entry.first;
            for (unsigned int b = 0; b < way.size(); ++b)
              way_of[b](dof) = way[b];
          }
      }
    const auto seen = [&](LA::Vector &values) {
      values.compress(VectorOperation::insert);
      LA::Vector ghosted(owned, relevant, communicator);
      ghosted = values;
      return ghosted;
    };
    const LA::Vector        original_seen = seen(original_of);
    std::vector<LA::Vector> way_seen;
    for (LA::Vector &values : way_of)
      way_seen.push_back(seen(values));
    for (const auto dof : relevant)
      if (original_seen(dof) > 0.)
        {
          Way way;
          for (const LA::Vector &values : way_seen)
            way.push_back(static_cast<int>(std::lround(values(dof))));
          nodes[dof] = {static_cast<types::global_dof_index>(
                          original_seen(dof) - 0.5),
                        motion_along(way, boundaries)};
        }
  }



  template <int dim>
  void
  PeriodicNodes<dim>::add_lines(Constraints &lines) const
  {
    for (const auto &[first, image] : nodes)
      {
        const Tensor<2, dim> Q = image.motion.template rotation_matrix<dim>();
        for (unsigned int c = 0; c < dim; ++c)
          {
            lines.add_line(first + c);
            for (unsigned int d = 0; d < dim; ++d)
              if (Q[c][d] != 0.)
                lines.add_entry(first + c, image.original + d, Q[c][d]);
          }
      }
  }

  template class PeriodicNodes<2>;
  template class PeriodicNodes<3>;
} // namespace stickslip
