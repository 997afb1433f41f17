#include <stickslip/contact/pairing/local_thickness.h>

#include <stickslip/contact/pairing/face_boxes.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/mpi.h>

#include <deal.II/boost_adaptors/segment.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// A ray may pass a facet by this fraction of its size, so that it does
    /// not slip through between neighbours.
    constexpr double between_facets = 1e-9;

    /// Boxes that each rank announces: enough to follow the hull of a body.
    constexpr unsigned int boxes_per_rank = 64;



    template <int dim>
    struct Ray
    {
      unsigned int   face = 0; ///< that it starts from
      Point<dim>     origin;
      Tensor<1, dim> direction; ///< unit vector

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &face &origin &direction;
      }
    };

    /// Where a ray leaves the body.
    using Exit = std::pair<unsigned int, double>; // face, distance



    /// A part of the boundary: a triangle (2D: a line) and its outward normal,
    /// not normalized.
    template <int dim>
    struct Facet
    {
      std::array<Point<dim>, dim> vertices;
      Tensor<1, dim>              outward;

      std::array<Tensor<1, dim>, dim - 1>
      edges() const
      {
        std::array<Tensor<1, dim>, dim - 1> result;
        for (unsigned int d = 0; d < dim - 1; ++d)
          result[d] = vertices[d + 1] - vertices[0];
        return result;
      }
    };



    template <int dim>
    Facet<dim>
    make_facet(const std::array<Point<dim>, dim> &vertices,
               const Point<dim>                  &inside)
    {
      Facet<dim> facet;
      facet.vertices = vertices;
      facet.outward  = surface_normal<dim>(facet.edges());
      if (facet.outward * (vertices[0] - inside) < 0.)
        facet.outward *= -1.;
      return facet;
    }



    /// Of the cells of this rank.
    template <int dim>
    std::vector<Facet<dim>>
    facets_of(const DoFHandler<dim>              &dof_handler,
              const std::set<types::boundary_id> &boundary_ids)
    {
      std::vector<Facet<dim>> facets;
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->is_locally_owned() && cell->at_boundary(f) &&
              boundary_ids.count(cell->face(f)->boundary_id()) > 0)
            {
              const auto face = cell->face(f);
              if constexpr (dim == 2)
                facets.push_back(
                  make_facet<2>({{face->vertex(0), face->vertex(1)}},
                                cell->center()));
              else
                // a quadrilateral has a second half
                for (unsigned int corner = 0; corner < face->n_vertices();
                     corner += 3)
                  facets.push_back(make_facet<3>(
                    {{face->vertex(corner), face->vertex(1), face->vertex(2)}},
                    cell->center()));
            }
      return facets;
    }



    /// How far along the ray it leaves through the facet; infinity if it does
    /// not.
    template <int dim>
    double
    distance_to_exit(const Ray<dim> &ray, const Facet<dim> &facet)
    {
      constexpr double never = std::numeric_limits<double>::infinity();
      if (ray.direction * facet.outward <= 0.)
        return never;
      // origin + t direction = vertex + sum_d s_d edge_d
      const auto     edges = facet.edges();
      Tensor<2, dim> matrix;
      for (unsigned int i = 0; i < dim; ++i)
        {
          matrix[i][0] = ray.direction[i];
          for (unsigned int d = 0; d < dim - 1; ++d)
            matrix[i][d + 1] = -edges[d][i];
        }
      const Tensor<1, dim> solution =
        invert(matrix) * (facet.vertices[0] - ray.origin);
      double rest = 1.;
      for (unsigned int d = 1; d < dim; ++d)
        {
          rest -= solution[d];
          if (solution[d] < -between_facets)
            return never;
        }
      return rest < -between_facets || solution[0] < 0. ? never : solution[0];
    }



    template <int dim>
    class FacetTree
    {
    public:
      explicit FacetTree(const std::vector<Facet<dim>> &facets)
        : facets(facets)
      {
        for (unsigned int i = 0; i < facets.size(); ++i)
          {
            const auto                       &vertices = facets[i].vertices;
            const std::vector<Tensor<1, dim>> points(vertices.begin(),
                                                     vertices.end());
            // a ray that meets a box just at its side meets it
            boxes.emplace_back(box_of(points, dim, 2. * between_facets), i);
          }
        tree = pack_rtree(boxes);
      }

      std::vector<BoundingBox<dim>>
      all_boxes() const
      {
        std::vector<BoundingBox<dim>> result;
        for (const auto &box : boxes)
          result.push_back(box.first);
        return result;
      }

      double
      distance_to_exit(const Ray<dim> &ray, const Segment<dim> &whole) const
      {
        namespace bgi  = boost::geometry::index;
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto &hit :
             tree | bgi::adaptors::queried(bgi::intersects(whole)))
          nearest =
            std::min(nearest,
                     stickslip::distance_to_exit(ray, facets[hit.second]));
        return nearest;
      }

    private:
      using Box = std::pair<BoundingBox<dim>, unsigned int>;

      const std::vector<Facet<dim>> &facets;
      std::vector<Box>               boxes;
      RTree<Box>                     tree;
    };



    template <int dim>
    Ray<dim>
    ray_from(const unsigned int      f,
             const SurfaceFace<dim> &face,
             const FaceShape<dim>   &shape)
    {
      const std::vector<Tensor<1, dim>> nodes  = face.undeformed_nodes();
      const FaceShapeValues<dim>       &centre = shape.at_centre();
      Ray<dim>                          ray;
      ray.face   = f;
      ray.origin = Point<dim>(interpolate<dim>(centre.value, nodes));
      ray.direction =
        face.orientation *
        surface_normal<dim>(surface_tangents<dim>(centre.gradient, nodes));
      ray.direction /= ray.direction.norm();
      return ray;
    }
  } // namespace



  template <int dim>
  void
  measure_thickness(const DoFHandler<dim>              &dof_handler,
                    const std::set<types::boundary_id> &boundary_of_body,
                    const MPI_Comm                     &communicator,
                    std::vector<CollectedFace<dim>>    &faces)
  {
    namespace bgi               = boost::geometry::index;
    const auto           facets = facets_of(dof_handler, boundary_of_body);
    const FacetTree<dim> tree(facets);

    // which rank has what is left to boxes, as with the master faces
    const auto announced =
      Utilities::MPI::all_gather(communicator,
                                 summarize(tree.all_boxes(), boxes_per_rank));
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    for (unsigned int rank = 0; rank < announced.size(); ++rank)
      for (const auto &box : announced[rank])
        boxes.emplace_back(box, rank);
    if (boxes.empty())
      return;
    BoundingBox<dim> body = boxes[0].first;
    for (const auto &box : boxes)
      body.merge_with(box.first);
    const double length = body.get_boundary_points().first.distance(
      body.get_boundary_points().second);
    const auto rank_tree = pack_rtree(boxes);
    const auto whole     = [length](const Ray<dim> &ray) {
      return Segment<dim>(ray.origin, ray.origin + length * ray.direction);
    };

    const ByKind<FaceShape<dim>> shapes(
      dof_handler.get_fe_collection(),
      [](const FiniteElement<dim> &fe, const unsigned int) {
        return std::make_unique<FaceShape<dim>>(
          fe.degree, faces_of<dim>(fe.reference_cell()));
      });
    std::map<unsigned int, std::vector<Ray<dim>>> rays;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        const Ray<dim> ray = ray_from(f, faces[f].face, shapes[faces[f].cell]);
        std::set<unsigned int> ranks;
        for (const auto &hit :
             rank_tree | bgi::adaptors::queried(bgi::intersects(whole(ray))))
          ranks.insert(hit.second);
        for (const unsigned int rank : ranks)
          rays[rank].push_back(ray);
      }
    std::map<unsigned int, std::vector<Exit>> exits;
    for (const auto &[rank, of_rank] :
         Utilities::MPI::some_to_some(communicator, rays))
      for (const Ray<dim> &ray : of_rank)
        exits[rank].emplace_back(ray.face,
                                 tree.distance_to_exit(ray, whole(ray)));
    for (const auto &[rank, of_rank] :
         Utilities::MPI::some_to_some(communicator, exits))
      for (const auto &[f, distance] : of_rank)
        faces[f].face.thickness = std::min(faces[f].face.thickness, distance);
  }

#define INSTANTIATE(dim)                                                \
  template void measure_thickness(const DoFHandler<dim> &,              \
                                  const std::set<types::boundary_id> &, \
                                  const MPI_Comm &,                     \
                                  std::vector<CollectedFace<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
