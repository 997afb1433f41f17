#include <stickslip/contact/pairing/segment_search.h>

#include <stickslip/contact/pairing/master_candidates.h>

#include <algorithm>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// A slave face is covered if no more than this fraction is not.
    constexpr double no_gap = 1e-9;



    /// An edge between neighbouring nodes of master faces.
    using Edge = std::pair<NodeName, NodeName>;



    /// Edges (2D: nodes) of a cell of a face, as add_ends() counts them.
    template <int dim>
    std::vector<Edge>
    edges_of(const SurfaceFace<dim> &face, const NodeCell<dim> &cell)
    {
      const auto       &corners = cell.corners;
      std::vector<Edge> edges;
      for (unsigned int i = 0; i < corners.size(); ++i)
        {
          const NodeName a = face.name(corners[i]);
          const NodeName b =
            dim == 2 ? a : face.name(corners[(i + 1) % corners.size()]);
          edges.emplace_back(std::min(a, b), std::max(a, b));
        }
      return edges;
    }



    using EdgeCounts = std::map<Edge, unsigned int>;



    template <int dim>
    void
    count_edges(const SurfaceFace<dim> &face,
                const FaceShape<dim>   &shape,
                EdgeCounts             &n_cells)
    {
      for (const auto &cell : shape.cells())
        for (const Edge &edge : edges_of(face, cell))
          ++n_cells[edge];
    }



    /// Edges that only one of the counted cells has.
    template <int dim>
    std::vector<std::vector<bool>>
    outer_edges(const SurfaceFace<dim> &face,
                const FaceShape<dim>   &shape,
                const EdgeCounts       &n_cells)
    {
      std::vector<std::vector<bool>> is_outer;
      for (const auto &cell : shape.cells())
        {
          is_outer.emplace_back();
          for (const Edge &edge : edges_of(face, cell))
            is_outer.back().push_back(n_cells.at(edge) == 1);
        }
      return is_outer;
    }



    /// The edges of a face itself. Where faces are curved all of them move:
    /// neighbours meet on the straight line between nodes only nearly.
    template <int dim>
    std::vector<std::vector<bool>>
    own_edges(const SurfaceFace<dim> &face, const FaceShape<dim> &shape)
    {
      EdgeCounts n_cells;
      count_edges(face, shape, n_cells);
      return outer_edges(face, shape, n_cells);
    }



    /// The borders of the segments that move over the slave face without a
    /// neighbour that moves alike.
    template <int dim>
    void
    add_ends(const MortarFace<dim>           &slave,
             const SegmentRule<dim>          &rule,
             const ProjectionPlane<dim>      &plane,
             const bool                       is_curved,
             ProjectedFace<dim>              &projected,
             std::vector<FaceCandidate<dim>> &candidates,
             const MasterPatch<dim>          &patch,
             FaceSegments<dim>               &segments)
    {
      const FaceShape<dim> &master_shape = rule.master_face_shape();
      EdgeCounts            n_cells;
      for (const auto &candidate : candidates)
        count_edges(patch.face(candidate.master), master_shape, n_cells);
      projected.moving_edges = own_edges(slave.face, rule.slave_face_shape());
      if (!is_curved) // a straight edge of the slave stays where it is on it
        for (auto &edges : projected.moving_edges)
          edges.assign(edges.size(), false);
      for (unsigned int i = 0; i < candidates.size(); ++i)
        {
          const SurfaceFace<dim> &master = patch.face(candidates[i].master);
          auto                   &face   = candidates[i].projected;
          face.moving_edges              = is_curved
                                             ? own_edges(master, master_shape)
                                             : outer_edges(master, master_shape, n_cells);
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
    const bool is_curved = dim == 3 && rule.slave_face_shape().degree() > 1;
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
      opposite.push_back({slave.face.id.original(),
                          patch.face(candidate.master).id.original(),
                          candidate.distance});
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
