#include <stickslip/contact/pairing/master_patch.h>

#include <stickslip/contact/pairing/face_boxes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <map>

namespace stickslip
{
  namespace
  {
    /// xi within [0,1] up to this is inside, so that shared edges leave no gap.
    constexpr double inside_tolerance = 1e-10;

    /// Distances that differ by less than this fraction of the face are equal.
    constexpr double tie_tolerance = 1e-9;



    /// The most that a facet is extended, as a fraction of the face.
    constexpr double largest_overlap = 0.5;

    /// The facet of the last pairing is kept without a search while the point
    /// is nearer to it than this fraction of the face, ...
    constexpr double kept_within = 0.25;

    /// ... or than this one if the point has an overlap: far away another face
    /// may be the nearer one, not indefinitely.
    constexpr double kept_within_with_overlap = 1.;

    /// Edges and corners are not searched if the point is nearer to the face on
    /// which it projects than this fraction of it.
    constexpr double edges_ignored_within = 0.25;

    /// Beyond that an edge is the partner if its distance is below this
    /// fraction of the distance of the face.
    constexpr double edge_preferred_below = 0.5;

    /// Overshoot over an edge that is allowed per distance. Over a convex edge
    /// the overshoot shrinks with the gap; beyond the end of the surface it
    /// does not.
    constexpr double overshoot_per_distance = 0.8;

    /// Least cosine of the angle between the slave's outward normal and n for a
    /// facet to be found: one that looks away is the far side of a thin body.
    constexpr double least_facing_to_find = 0.1;

    /// The same for the facet of the last pairing to be kept.
    constexpr double least_facing_to_keep = 0.1;

    /// Curved faces may bulge out of the box of their nodes by this fraction of
    /// its diagonal.
    constexpr double bulge = 0.1;

    /// Boxes that each rank announces: enough to follow a bent surface.
    constexpr unsigned int n_announced_boxes = 16;

    /// The nearest few faces nearly always hold the answer; bent surfaces with
    /// large boxes need all within the search distance.
    template <int dim>
    constexpr unsigned int n_near = dim == 2 ? 6 : 16;
  } // namespace



  template <int dim>
  void
  read_positions(const SurfaceFace<dim>      &face,
                 const unsigned int           n,
                 const LA::Vector            &u,
                 std::vector<Tensor<1, dim>> &positions)
  {
    positions.resize(n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int c = 0; c < dim; ++c)
        positions[j][c] =
          face.reference_positions[j][c] + u(face.dofs[j * dim + c]);
  }



  template <int dim>
  MasterPatch<dim>::MasterPatch(std::vector<SurfaceFace<dim>> owned_faces,
                                const FaceShape<dim>         &shape,
                                const PairingTolerances      &tolerances,
                                const MPI_Comm               &communicator)
    : owned(std::move(owned_faces))
    , shape(shape)
    , tolerances(tolerances)
    , communicator(communicator)
  {}



  template <int dim>
  void
  MasterPatch<dim>::fetch(const std::vector<BoundingBox<dim>> &slave_boxes,
                          const LA::Vector                    &u,
                          const double                         margin)
  {
    std::vector<BoundingBox<dim>> announced =
      summarize(slave_boxes, n_announced_boxes);
    for (auto &box : announced)
      box = enlarged(box, tolerances.search_distance + margin);
    const auto all = Utilities::MPI::all_gather(communicator, announced);

    std::vector<Box>            boxes;
    std::vector<Tensor<1, dim>> positions;
    for (unsigned int f = 0; f < owned.size(); ++f)
      {
        read_positions(owned[f], owned[f].n_nodes, u, positions);
        boxes.emplace_back(box_of(positions, owned[f].n_nodes, bulge), f);
      }
    const RTree<Box> owned_tree = pack_rtree(boxes);

    std::map<unsigned int, std::vector<SurfaceFace<dim>>> to_send;
    for (unsigned int rank = 0; rank < all.size(); ++rank)
      {
        std::vector<unsigned int> wanted;
        for (const auto &box : all[rank])
          for (const auto &hit :
               owned_tree | boost::geometry::index::adaptors::queried(
                              boost::geometry::index::intersects(box)))
            wanted.push_back(hit.second);
        std::sort(wanted.begin(), wanted.end());
        wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
        for (const unsigned int f : wanted)
          to_send[rank].push_back(owned[f]);
      }
    const auto received = Utilities::MPI::some_to_some(communicator, to_send);
    faces.clear();
    for (const auto &from : received)
      faces.insert(faces.end(), from.second.begin(), from.second.end());
    std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });
    current.resize(faces.size());
    old.resize(faces.size());
  }



  template <int dim>
  std::vector<types::global_dof_index>
  MasterPatch<dim>::dofs() const
  {
    std::vector<types::global_dof_index> result;
    for (const auto &face : faces)
      result.insert(result.end(), face.dofs.begin(), face.dofs.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }



  template <int dim>
  unsigned int
  MasterPatch<dim>::index_of(const FaceId &id) const
  {
    const auto position = std::lower_bound(
      faces.begin(), faces.end(), id, [](const auto &face, const FaceId &name) {
        return face.id < name;
      });
    return position != faces.end() && position->id == id
             ? position - faces.begin()
             : faces.size();
  }



  template <int dim>
  void
  MasterPatch<dim>::relocate(Pairing<dim> &pairing) const
  {
    if (pairing.paired)
      pairing.face = index_of(pairing.face_id);
  }



  template <int dim>
  void
  MasterPatch<dim>::update(const LA::Vector &u, const LA::Vector &u_old)
  {
    std::vector<Box> boxes;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        read_positions(faces[f],
                       faces[f].n_stencil_nodes(),
                       u,
                       current[f].positions);
        update_nodal_normals(faces[f], current[f]);
        read_positions(faces[f], faces[f].n_nodes, u_old, old[f].positions);
        boxes.emplace_back(
          box_of(current[f].positions, faces[f].n_nodes, bulge), f);
      }
    tree = pack_rtree(boxes);
  }



  template <int dim>
  std::vector<unsigned int>
  MasterPatch<dim>::faces_near(
    const std::vector<Tensor<1, dim>> &positions) const
  {
    const auto box = enlarged(box_of(positions, positions.size(), 0.),
                              tolerances.search_distance);
    std::vector<unsigned int> near;
    for (const auto &hit : tree | boost::geometry::index::adaptors::queried(
                                    boost::geometry::index::intersects(box)))
      near.push_back(hit.second);
    std::sort(near.begin(), near.end());
    return near;
  }



  template <int dim>
  std::vector<std::pair<double, unsigned int>>
  MasterPatch<dim>::candidates(const Tensor<1, dim> &x_s,
                               const unsigned int    at_most) const
  {
    const Point<dim>                             x(x_s);
    std::vector<std::pair<double, unsigned int>> result;
    for (const auto &hit :
         tree | boost::geometry::index::adaptors::queried(
                  boost::geometry::index::nearest(x, at_most)))
      {
        const double distance = boost::geometry::distance(x, hit.first);
        if (distance <= tolerances.search_distance)
          result.emplace_back(distance, hit.second);
      }
    std::sort(result.begin(), result.end());
    return result;
  }



  template <int dim>
  Pairing<dim>
  MasterPatch<dim>::nearest(
    const Tensor<1, dim>                               &x_s,
    const Tensor<1, dim>                               &slave_normal,
    const std::vector<std::pair<double, unsigned int>> &candidates,
    const EdgeRetention                                &retention,
    const bool                                          on_edges,
    double                                             &distance) const
  {
    Pairing<dim>     best;
    MasterPoint<dim> point;
    distance = std::numeric_limits<double>::max();
    for (const auto &[box_distance, f] : candidates)
      {
        const double tie = tie_tolerance * faces[f].diameter;
        if (box_distance > distance + tie)
          break;
        const auto projection =
          on_edges
            ? project_on_boundary_of_face(faces[f], current[f], shape, x_s)
            : project_on_face(
                faces[f], current[f], shape, x_s, inside_tolerance);
        const double allowed =
          (tolerances.projection_tolerance +
           (retention.beyond_end ? tolerances.end_overlap : 0.)) *
            faces[f].diameter +
          overshoot_per_distance * projection.distance;
        if (!projection.found ||
            projection.distance > tolerances.search_distance ||
            projection.overshoot > allowed)
          continue;
        const bool is_nearer = projection.distance < distance - tie;
        const bool is_tie = !is_nearer && projection.distance < distance + tie;
        if (!(is_nearer || (is_tie && f < best.face)))
          continue;
        evaluate_master_point(
          faces[f], current[f], shape, projection.xi, point);
        if (point.n * slave_normal <= least_facing_to_find)
          continue;
        distance     = std::min(distance, projection.distance);
        best.paired  = true;
        best.face    = f;
        best.face_id = faces[f].id;
        best.xi      = projection.xi;
        best.free    = projection.free;
        best.n       = point.n;
      }
    return best;
  }



  template <int dim>
  Pairing<dim>
  MasterPatch<dim>::find(const Tensor<1, dim> &x_s,
                         const Tensor<1, dim> &slave_normal,
                         const Pairing<dim>   &last,
                         const EdgeRetention  &retention) const
  {
    if (faces.empty())
      return Pairing<dim>();
    const double overlap = retention.overlap_factor * tolerances.facet_overlap;
    if (last.paired && contains(last) && (last.is_interior() || overlap > 0.))
      {
        const unsigned int f          = last.face;
        const auto         projection = project_on_face(faces[f],
                                                current[f],
                                                shape,
                                                x_s,
                                                std::clamp(overlap,
                                                           inside_tolerance,
                                                           largest_overlap));
        const double       farthest =
          (overlap > 0. ? kept_within_with_overlap : kept_within) *
          faces[f].diameter;
        if (projection.found && projection.distance < farthest)
          {
            MasterPoint<dim> point;
            evaluate_master_point(
              faces[f], current[f], shape, projection.xi, point);
            Pairing<dim> frame = last;
            frame.free         = everywhere<dim>();
            frame.xi           = projection.xi;
            frame.n            = point.n;
            if (frame.n * slave_normal > least_facing_to_keep)
              return frame;
          }
      }
    auto         near = candidates(x_s, n_near<dim>);
    double       distance, edge_distance;
    Pairing<dim> frame =
      nearest(x_s, slave_normal, near, retention, false, distance);
    if (frame.paired &&
        distance < edges_ignored_within * faces[frame.face].diameter)
      return frame;
    if (!frame.paired && near.size() == n_near<dim>)
      {
        near  = candidates(x_s, faces.size());
        frame = nearest(x_s, slave_normal, near, retention, false, distance);
      }
    // The point may hang over a convex edge close by although it projects on
    // some face far away.
    const Pairing<dim> edge =
      nearest(x_s, slave_normal, near, retention, true, edge_distance);
    return edge.paired && edge_distance < edge_preferred_below * distance
             ? edge
             : frame;
  }

  template void
  read_positions(const SurfaceFace<2> &,
                 const unsigned int,
                 const LA::Vector &,
                 std::vector<Tensor<1, 2>> &);
  template void
  read_positions(const SurfaceFace<3> &,
                 const unsigned int,
                 const LA::Vector &,
                 std::vector<Tensor<1, 3>> &);
  template class MasterPatch<2>;
  template class MasterPatch<3>;
} // namespace stickslip
