#include <stickslip/contact/pairing/segment_search.h>

#include <stickslip/contact/pairing/possible_penetration.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Projections of two master faces that share less than this fraction of
    /// the slave face do not lie behind each other.
    constexpr double no_overlap = 1e-6;



    /// A slave face is covered if no more than this fraction is not.
    constexpr double no_gap = 1e-9;



    /// A point of a surface that meets itself has come in if it is not deeper
    /// than this fraction of the faces and of the thickness of the body.
    constexpr double come_in = 0.25;

    /// The back of a body is not farther away than this times its thickness.
    constexpr double thick = 1.5;



    /// A master face above or below a slave face.
    template <int dim>
    struct Candidate
    {
      unsigned int                   master = 0;
      ProjectedFace<dim>             projected;
      std::vector<SegmentPoint<dim>> points;
      double                         area     = 0.; ///< undeformed
      double                         distance = 0.; ///< mean, without sign
      SearchingPoint<dim>            middle;        ///< of the segments, mean
      PossiblePartner<dim>           partner;       ///< opposite
    };



    /// Where the segments of a candidate are when the slave and the master
    /// nodes are there: the mean over them.
    template <int dim>
    void
    middle_of_segments(const std::vector<SegmentPoint<dim>> &points,
                       const FaceShape<dim>                 &shape,
                       const std::vector<Tensor<1, dim>>    &slave,
                       const std::vector<Tensor<1, dim>>    &master,
                       Tensor<1, dim>                       &on_slave,
                       Tensor<1, dim>                       &on_master)
    {
      std::vector<double> N, N_master;
      double              area = 0.;
      for (const auto &point : points)
        {
          shape.evaluate_values(point.xi, N);
          shape.evaluate_values(point.eta, N_master);
          area += point.weight;
          on_slave += point.weight * interpolate<dim>(N, slave);
          on_master += point.weight * interpolate<dim>(N_master, master);
        }
      on_slave /= area;
      on_master /= area;
    }



    template <int dim>
    void
    measure_candidate(const MortarFace<dim>      &slave,
                      const ProjectionPlane<dim> &plane,
                      const MasterPatch<dim>     &patch,
                      Candidate<dim>             &candidate)
    {
      const FaceShape<dim> &shape   = patch.face_shape();
      auto                 &middle  = candidate.middle;
      auto                 &partner = candidate.partner;
      for (const auto &point : candidate.points)
        candidate.area += point.weight;
      middle_of_segments(candidate.points,
                         shape,
                         slave.positions,
                         patch.configuration(candidate.master).positions,
                         middle.x,
                         partner.x);
      candidate.distance = std::abs((partner.x - middle.x) * plane.n);
      middle.normal      = plane.n;
      middle.thickness   = slave.face.thickness;
      middle.face_nodes  = &slave.positions;
      partner.face       = candidate.master;
      partner.n          = plane.n;
      if (!patch.tolerances.is_own_master && is_level(middle, partner, patch))
        return;
      middle_of_segments(candidate.points,
                         shape,
                         slave.old_positions,
                         patch.old_configuration(candidate.master).positions,
                         middle.x_old,
                         partner.x_old);
      partner.n_old =
        projection_plane(slave.face, shape, slave.old_positions).n;
    }



    /// Of faces of one body: depth up to which one has come in at the other.
    template <int dim>
    double
    deepest(const MortarFace<dim> &slave, const SurfaceFace<dim> &master)
    {
      return come_in * std::min({slave.face.diameter,
                                 master.diameter,
                                 slave.face.thickness,
                                 master.thickness});
    }



    /// True if the segments of @p candidate are on the back of the body, seen
    /// from the slave face, which no deformation brings to its front.
    template <int dim>
    bool
    is_back(const MortarFace<dim>  &slave,
            const Candidate<dim>   &candidate,
            const MasterPatch<dim> &patch)
    {
      const SurfaceFace<dim>           &master = patch.face(candidate.master);
      const FaceShape<dim>             &shape  = patch.face_shape();
      const std::vector<Tensor<1, dim>> nodes  = slave.face.undeformed_nodes();
      Tensor<1, dim>                    X_s, X_m;
      middle_of_segments(
        candidate.points, shape, nodes, master.undeformed_nodes(), X_s, X_m);
      const Tensor<1, dim> through = X_m - X_s;
      return through * projection_plane(slave.face, shape, nodes).n <
               -deepest(slave, master) &&
             through.norm() <=
               thick * std::min(slave.face.thickness, master.thickness);
    }



    /// can_be_partners() for two faces of one body. A surface that has not met
    /// itself yet has no penetrations, and what lies far behind a face is its
    /// own body.
    template <int dim>
    bool
    can_meet(const MortarFace<dim>  &slave,
             const Candidate<dim>   &candidate,
             const MasterPatch<dim> &patch)
    {
      const Depth depth = depth_of(candidate.middle, candidate.partner);
      return std::min(depth.now, depth.at_start) <=
               deepest(slave, patch.face(candidate.master)) &&
             !is_back(slave, candidate, patch);
    }



    /// True if, above the slave face, the projections @p a and @p b overlap.
    template <int dim>
    bool
    overlap(const ProjectedFace<dim> &slave,
            const ProjectedFace<dim> &a,
            const ProjectedFace<dim> &b)
    {
      double common = 0., whole = 0.;
      for (const auto &cell : slave.cells)
        {
          whole += measure<dim - 1>(cell);
          for (const auto &cell_a : a.cells)
            for (const auto &cell_b : b.cells)
              common += measure<dim - 1>(
                intersection<dim - 1>(intersection<dim - 1>(cell, cell_a),
                                      cell_b));
        }
      return common > no_overlap * whole;
    }



    /// True if candidates are farther from each other than a body is thick:
    /// they are not one surface.
    template <int dim>
    bool
    are_apart(const std::vector<Candidate<dim>> &candidates,
              const MasterPatch<dim>            &patch)
    {
      if (candidates.empty())
        return false;
      const auto height = [&](const Candidate<dim> &candidate) {
        return depth_of(candidate.middle, candidate.partner).now;
      };
      double low = height(candidates[0]), high = low,
             thickness = std::numeric_limits<double>::infinity();
      for (const auto &candidate : candidates)
        {
          low  = std::min(low, height(candidate));
          high = std::max(high, height(candidate));
          thickness =
            std::min(thickness, patch.face(candidate.master).thickness);
        }
      return high - low > thickness;
    }



    /// Of candidates that lie behind each other only the nearest is a partner,
    /// and none behind a body that the slave has come into.
    template <int dim>
    void
    drop_hidden(const ProjectedFace<dim>    &slave,
                const MasterPatch<dim>      &patch,
                std::vector<Candidate<dim>> &candidates)
    {
      const std::vector<Candidate<dim>> all = candidates;
      const auto is_hidden = [&](const Candidate<dim> &candidate) {
        return std::any_of(all.begin(), all.end(), [&](const auto &entered) {
          return hides(entered.middle,
                       entered.partner,
                       candidate.partner,
                       patch) &&
                 overlap(slave, entered.projected, candidate.projected);
        });
      };
      candidates.erase(std::remove_if(candidates.begin(),
                                      candidates.end(),
                                      is_hidden),
                       candidates.end());
      std::stable_sort(candidates.begin(),
                       candidates.end(),
                       [](const auto &a, const auto &b) {
                         return a.distance < b.distance;
                       });
      std::vector<Candidate<dim>> kept;
      for (const auto &candidate : candidates)
        if (std::none_of(kept.begin(), kept.end(), [&](const auto &nearer) {
              return overlap(slave, nearer.projected, candidate.projected);
            }))
          kept.push_back(candidate);
      std::sort(kept.begin(), kept.end(), [](const auto &a, const auto &b) {
        return a.master < b.master;
      });
      candidates.swap(kept);
    }
    /// An edge between neighbouring nodes of master faces.
    using Edge = std::pair<types::global_dof_index, types::global_dof_index>;



    /// Edges (2D: nodes) of cell @p j of a face, as add_ends() counts them.
    template <int dim>
    std::vector<Edge>
    edges_of(const SurfaceFace<dim>   &face,
             const ProjectedFace<dim> &projected,
             const unsigned int        j)
    {
      const auto       &corners = projected.corners[j];
      std::vector<Edge> edges;
      for (unsigned int i = 0; i < corners.size(); ++i)
        {
          const auto a = face.dofs[corners[i] * dim];
          const auto b =
            dim == 2 ? a : face.dofs[corners[(i + 1) % corners.size()] * dim];
          edges.emplace_back(std::min(a, b), std::max(a, b));
        }
      return edges;
    }



    using EdgeCounts = std::map<Edge, unsigned int>;



    template <int dim>
    void
    count_edges(const SurfaceFace<dim>   &face,
                const ProjectedFace<dim> &projected,
                EdgeCounts               &n_cells)
    {
      for (unsigned int j = 0; j < projected.cells.size(); ++j)
        for (const Edge &edge : edges_of(face, projected, j))
          ++n_cells[edge];
    }



    /// Edges that only one of the counted cells has.
    template <int dim>
    std::vector<std::vector<bool>>
    outer_edges(const SurfaceFace<dim>   &face,
                const ProjectedFace<dim> &projected,
                const EdgeCounts         &n_cells)
    {
      std::vector<std::vector<bool>> is_outer(projected.cells.size());
      for (unsigned int j = 0; j < is_outer.size(); ++j)
        for (const Edge &edge : edges_of(face, projected, j))
          is_outer[j].push_back(n_cells.at(edge) == 1);
      return is_outer;
    }



    /// The edges of a face itself. Where faces are curved all of them move:
    /// neighbours meet on the straight line between nodes only nearly.
    template <int dim>
    std::vector<std::vector<bool>>
    own_edges(const SurfaceFace<dim> &face, const ProjectedFace<dim> &projected)
    {
      EdgeCounts n_cells;
      count_edges(face, projected, n_cells);
      return outer_edges(face, projected, n_cells);
    }



    /// The borders of the segments that move over the slave face without a
    /// neighbour that moves alike.
    template <int dim>
    void
    add_ends(const MortarFace<dim>       &slave,
             const SegmentRule<dim>      &rule,
             const ProjectionPlane<dim>  &plane,
             const bool                   is_curved,
             ProjectedFace<dim>          &projected,
             std::vector<Candidate<dim>> &candidates,
             const MasterPatch<dim>      &patch,
             FaceSegments<dim>           &segments)
    {
      EdgeCounts n_cells;
      for (const auto &candidate : candidates)
        count_edges(patch.face(candidate.master), candidate.projected, n_cells);
      projected.moving_edges = own_edges(slave.face, projected);
      if (!is_curved) // a straight edge of the slave stays where it is on it
        for (auto &edges : projected.moving_edges)
          edges.assign(edges.size(), false);
      for (unsigned int i = 0; i < candidates.size(); ++i)
        {
          const SurfaceFace<dim> &master = patch.face(candidates[i].master);
          auto                   &face   = candidates[i].projected;
          face.moving_edges              = is_curved ? own_edges(master, face)
                                                     : outer_edges(master, face, n_cells);
          rule.add_ends(plane,
                        {slave.positions, projected},
                        slave.face.reference_positions,
                        {patch.configuration(candidates[i].master).positions,
                         face},
                        i,
                        segments.ends);
        }
    }
  } // namespace



  namespace
  {
    /// The slave face as it is seen, and the master faces opposite.
    template <int dim>
    struct SeenFrom
    {
      ProjectionPlane<dim>        plane;
      ProjectedFace<dim>          projected;
      std::vector<Candidate<dim>> candidates;
    };



    template <int dim>
    double
    covered_area(const std::vector<Candidate<dim>> &candidates)
    {
      double area = 0.;
      for (const auto &candidate : candidates)
        area += candidate.area;
      return area;
    }



    template <int dim>
    SeenFrom<dim>
    look_from(const MortarFace<dim>  &slave,
              const SegmentRule<dim> &rule,
              const MasterPatch<dim> &patch)
    {
      const FaceShape<dim> &shape = rule.face_shape();
      SeenFrom<dim>         seen;
      auto                 &plane     = seen.plane;
      auto                 &projected = seen.projected;
      plane     = projection_plane(slave.face, shape, slave.positions);
      projected = project(shape, slave.positions, plane);
      for (const unsigned int m : patch.faces_near(slave.positions))
        {
          const auto &nodes  = patch.configuration(m).positions;
          const auto  master = projection_plane(patch.face(m), shape, nodes);
          if (-(master.n * plane.n) <= patch.tolerances.least_cosine)
            continue;
          Candidate<dim> candidate;
          candidate.master    = m;
          candidate.projected = project(shape, nodes, plane);
          rule.add_points(plane,
                          {slave.positions, projected},
                          slave.face.reference_positions,
                          {nodes, candidate.projected},
                          0,
                          candidate.points);
          if (candidate.points.empty())
            continue;
          measure_candidate(slave, plane, patch, candidate);
          if (candidate.distance > patch.tolerances.search_distance ||
              !(patch.tolerances.is_own_master
                  ? can_meet(slave, candidate, patch)
                  : can_be_partners(candidate.middle,
                                    candidate.partner,
                                    patch)))
            continue;
          seen.candidates.push_back(candidate);
        }
      if (covered_area(seen.candidates) > (1. + no_overlap) * slave.area ||
          are_apart(seen.candidates, patch))
        drop_hidden(projected, patch, seen.candidates);
      return seen;
    }
  } // namespace



  template <int dim>
  FaceSegments<dim>
  find_segments(const MortarFace<dim>                     &slave,
                const SegmentRule<dim>                    &rule,
                const MasterPatch<dim>                    &patch,
                const std::function<bool(const FaceId &)> &is_master)
  {
    auto  seen       = look_from(slave, rule, patch);
    auto &candidates = seen.candidates;
    // not before: what they hide stays hidden
    if (is_master)
      candidates.erase(std::remove_if(candidates.begin(),
                                      candidates.end(),
                                      [&](const auto &candidate) {
                                        return !is_master(
                                          patch.face(candidate.master).id);
                                      }),
                       candidates.end());

    FaceSegments<dim> segments;
    const bool        is_curved = dim == 3 && rule.face_shape().degree() > 1;
    if (covered_area(candidates) < (1. - no_gap) * slave.area || is_curved)
      add_ends(slave,
               rule,
               seen.plane,
               is_curved,
               seen.projected,
               candidates,
               patch,
               segments);
    for (auto &candidate : candidates)
      {
        for (auto &point : candidate.points)
          {
            point.master = segments.masters.size();
            segments.points.push_back(point);
          }
        segments.masters.push_back(candidate.master);
        segments.master_ids.push_back(patch.face(candidate.master).id);
      }
    return segments;
  }



  template <int dim>
  std::vector<OppositeFaces>
  find_opposite(const MortarFace<dim>  &slave,
                const SegmentRule<dim> &rule,
                const MasterPatch<dim> &patch)
  {
    std::vector<OppositeFaces> opposite;
    for (const auto &candidate : look_from(slave, rule, patch).candidates)
      opposite.push_back(
        {slave.face.id, patch.face(candidate.master).id, candidate.distance});
    return opposite;
  }

#define INSTANTIATE(dim)                                                      \
  template FaceSegments<dim> find_segments(                                   \
    const MortarFace<dim> &,                                                  \
    const SegmentRule<dim> &,                                                 \
    const MasterPatch<dim> &,                                                 \
    const std::function<bool(const FaceId &)> &);                             \
  template std::vector<OppositeFaces> find_opposite(const MortarFace<dim> &,  \
                                                    const SegmentRule<dim> &, \
                                                    const MasterPatch<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
