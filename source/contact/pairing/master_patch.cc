#include <stickslip/contact/pairing/master_patch.h>

#include <stickslip/base/over_ranks.h>

#include <stickslip/contact/pairing/face_boxes.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

namespace stickslip
{
  namespace
  {
    /// Curved faces may bulge out of the box of their nodes by this fraction of
    /// its diagonal.
    constexpr double bulge = 0.1;

    /// Boxes that each rank announces: enough to follow a bent surface.
    constexpr unsigned int n_announced_boxes = 16;



    /// A box, parallel to the axes, around what a box is moved to.
    template <int dim>
    BoundingBox<dim>
    moved(const BoundingBox<dim> &box, const PeriodicMotion &motion)
    {
      std::vector<Point<dim>> corners;
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        corners.emplace_back(motion(Tensor<1, dim>(box.vertex(v))));
      return BoundingBox<dim>(corners);
    }
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
      {
        Tensor<1, dim> u_j;
        for (unsigned int c = 0; c < dim; ++c)
          u_j[c] = u(face.dofs[j * dim + c]);
        if (!face.rotations.empty())
          u_j = face.rotations[j] * u_j;
        positions[j] = face.reference_positions[j] + u_j;
      }
  }



  template <int dim>
  MasterPatch<dim>::MasterPatch(std::vector<SurfaceFace<dim>> owned_faces,
                                const FaceShape<dim>         &shape,
                                const PairingTolerances      &tolerances,
                                const MPI_Comm               &communicator,
                                std::shared_ptr<const RigidTool<dim>> tool,
                                MasterImages<dim>                     images)
    : tolerances(tolerances)
    , owned(std::move(owned_faces))
    , images(std::move(images))
    , shape(shape)
    , communicator(communicator)
    , rigid_tool(std::move(tool))
  {}



  template <int dim>
  void
  MasterPatch<dim>::evaluate_values(const unsigned int    chart,
                                    const Point<dim - 1> &xi,
                                    std::vector<double>  &N) const
  {
    if (!rigid_tool)
      return shape.evaluate_values(xi, N);
    N = rigid_tool->frame.weights(rigid_tool->surface.evaluate(chart, xi).x);
  }



  template <int dim>
  void
  MasterPatch<dim>::evaluate(const Pairing<dim>             &pairing,
                             const MasterConfiguration<dim> &configuration,
                             MasterPoint<dim>               &point) const
  {
    if (rigid_tool)
      rigid_tool->evaluate(configuration.positions,
                           pairing.chart,
                           pairing.xi,
                           point);
    else
      evaluate_master_point(
        faces[pairing.face], configuration, shape, pairing.xi, point);
  }



  template <int dim>
  bool
  MasterPatch<dim>::fetch(const std::vector<BoundingBox<dim>> &slave_boxes,
                          const LA::Vector                    &u,
                          const double                         margin)
  {
    std::vector<BoundingBox<dim>> announced =
      summarize(slave_boxes, n_announced_boxes);
    for (auto &box : announced)
      box = enlarged(box, tolerances.search_distance + margin);
    const auto all  = Utilities::MPI::all_gather(communicator, announced);
    const auto tree = tree_of_owned_faces(u);

    std::map<unsigned int, Changes> to_send;
    for (unsigned int rank = 0; rank < all.size(); ++rank)
      {
        const std::vector<OwnedImage> wanted = owned_images_in(all[rank], tree);
        if (wanted.empty() && held_by.count(rank) == 0)
          continue; // most ranks, where there are many
        std::vector<OwnedImage> &held = held_by[rank];
        if (wanted == held)
          continue;
        std::vector<OwnedImage> added, removed;
        std::set_difference(wanted.begin(),
                            wanted.end(),
                            held.begin(),
                            held.end(),
                            std::back_inserter(added));
        std::set_difference(held.begin(),
                            held.end(),
                            wanted.begin(),
                            wanted.end(),
                            std::back_inserter(removed));
        Changes &changes = to_send[rank];
        for (const auto &[f, image] : added)
          {
            if (image == 0)
              changes.added.push_back(owned[f]);
            else if (const auto face = images.all->image_of(owned[f], image))
              changes.added.push_back(*face);
          }
        for (const auto &[f, image] : removed)
          {
            changes.removed.push_back(owned[f].id);
            changes.removed.back().image = image;
          }
        held = wanted;
      }
    if (!any_rank(!to_send.empty(), communicator))
      return false;
    for (const auto &[rank, changes] :
         Utilities::MPI::some_to_some(communicator, to_send))
      apply(changes);
    std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });
    current.resize(faces.size());
    old.resize(faces.size());
    thickness_of_thinnest = std::numeric_limits<double>::infinity();
    for (const auto &face : faces)
      thickness_of_thinnest = std::min(thickness_of_thinnest, face.thickness);
    return true;
  }



  template <int dim>
  RTree<typename MasterPatch<dim>::Box>
  MasterPatch<dim>::tree_of_owned_faces(const LA::Vector &u) const
  {
    std::vector<Box>            boxes;
    std::vector<Tensor<1, dim>> positions;
    for (unsigned int f = 0; f < owned.size(); ++f)
      {
        read_positions(owned[f], owned[f].n_nodes, u, positions);
        boxes.emplace_back(box_of(positions, owned[f].n_nodes, bulge), f);
      }
    return pack_rtree(boxes);
  }



  template <int dim>
  std::vector<typename MasterPatch<dim>::OwnedImage>
  MasterPatch<dim>::owned_images_in(const std::vector<BoundingBox<dim>> &boxes,
                                    const RTree<Box> &tree_of_owned) const
  {
    std::vector<OwnedImage> result;
    if (rigid_tool)
      {
        if (!boxes.empty() && !owned.empty())
          result = {{0, 0}};
        return result;
      }
    const auto add = [&](const BoundingBox<dim> &box,
                         const unsigned int      image) {
      for (const auto &hit :
           tree_of_owned | boost::geometry::index::adaptors::queried(
                             boost::geometry::index::intersects(box)))
        result.emplace_back(hit.second, image);
    };
    for (const auto &box : boxes)
      {
        add(box, 0);
        for (const unsigned int image : images.numbers)
          add(moved(box, images.all->motion(image).inverse()), image);
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }



  template <int dim>
  void
  MasterPatch<dim>::apply(const Changes &changes)
  {
    const std::set<FaceId> removed(changes.removed.begin(),
                                   changes.removed.end());
    faces.erase(std::remove_if(faces.begin(),
                               faces.end(),
                               [&](const SurfaceFace<dim> &face) {
                                 return removed.count(face.id) > 0;
                               }),
                faces.end());
    faces.insert(faces.end(), changes.added.begin(), changes.added.end());
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
    largest_motion = 0.;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        read_positions(faces[f],
                       faces[f].n_stencil_nodes(),
                       u,
                       current[f].positions);
        update_nodal_normals(faces[f], current[f]);
        read_positions(faces[f], faces[f].n_nodes, u_old, old[f].positions);
        for (unsigned int j = 0; j < faces[f].n_nodes; ++j)
          largest_motion =
            std::max(largest_motion,
                     (current[f].positions[j] - old[f].positions[j]).norm());
        boxes.emplace_back(
          box_of(current[f].positions, faces[f].n_nodes, bulge), f);
      }
    tree = pack_rtree(boxes);
  }



  template <int dim>
  std::vector<unsigned int>
  MasterPatch<dim>::faces_in(const BoundingBox<dim> &box) const
  {
    std::vector<unsigned int> result;
    for (const auto &hit : tree | boost::geometry::index::adaptors::queried(
                                    boost::geometry::index::intersects(box)))
      result.push_back(hit.second);
    std::sort(result.begin(), result.end());
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  MasterPatch<dim>::faces_near(
    const std::vector<Tensor<1, dim>> &positions) const
  {
    return faces_in(enlarged(box_of(positions, positions.size(), 0.),
                             tolerances.search_distance));
  }



  template <int dim>
  std::vector<std::pair<double, unsigned int>>
  MasterPatch<dim>::nearest_boxes(const Tensor<1, dim> &x_s,
                                  const unsigned int    at_most) const
  {
    const Point<dim> x(x_s);
    return boxes_within_reach(x,
                              tree |
                                boost::geometry::index::adaptors::queried(
                                  boost::geometry::index::nearest(x, at_most)));
  }



  template <int dim>
  std::vector<std::pair<double, unsigned int>>
  MasterPatch<dim>::all_boxes(const Tensor<1, dim> &x_s) const
  {
    return boxes_within_reach(Point<dim>(x_s),
                              tree |
                                boost::geometry::index::adaptors::queried(
                                  boost::geometry::index::intersects(
                                    enlarged(box_of<dim>({x_s}, 1, 0.),
                                             tolerances.search_distance))));
  }



  template <int dim>
  template <typename Hits>
  std::vector<std::pair<double, unsigned int>>
  MasterPatch<dim>::boxes_within_reach(const Point<dim> &x,
                                       const Hits       &hits) const
  {
    std::vector<std::pair<double, unsigned int>> result;
    for (const auto &hit : hits)
      {
        const double distance = boost::geometry::distance(x, hit.first);
        if (distance <= tolerances.search_distance)
          result.emplace_back(distance, hit.second);
      }
    std::sort(result.begin(), result.end());
    return result;
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
