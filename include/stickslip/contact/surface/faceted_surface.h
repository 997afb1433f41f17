#ifndef stickslip_contact_surface_faceted_surface_h
#define stickslip_contact_surface_faceted_surface_h

#include <stickslip/contact/surface/surface_face.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace stickslip
{
  /// The smaller one of two of the same sign, or 0.
  double
  less_curved(const double a, const double b);

  /// At the plane with the unit normal @p N.
  template <int dim>
  Tensor<1, dim>
  mirrored(const Tensor<1, dim> &v, const Tensor<1, dim> &N)
  {
    return v - 2. * (v * N) * N;
  }

  /// The unit vectors along which a node of a face is held.
  template <int dim>
  using HeldDirections =
    std::function<std::vector<Tensor<1, dim>>(const SurfaceFace<dim> &,
                                              const unsigned int)>;

  /**
   * The facets of a surface where nothing is deformed (the faces between their
   * vertices), who lies beside whom, and how far the smooth surface behind a
   * facet is outside of it by what its neighbours say.
   *
   * Edges of a facet: of lines and quadrilaterals edge 2 d + s is at the end s
   * of direction d, so that e ^ 1 is opposite; of triangles edge e is that from
   * node e to the next.
   */
  template <int dim>
  class FacetedSurface
  {
  public:
    /// Edges at which facets meet at more than @p sharpest_turn [radian] are
    /// sharp: there is nothing beside them. @p face_shape is that of the faces,
    /// @p held_directions those that a node of a face cannot move in,
    /// unless it cannot move at all: where the surface ends there, the mirror
    /// image is beside it.
    FacetedSurface(const FaceShape<dim>                  &face_shape,
                   const double                           sharpest_turn,
                   const HeldDirections<dim>             &held_directions,
                   const std::vector<CollectedFace<dim>> &faces);

    unsigned int
    n_edges() const
    {
      return shape.is_triangle() ? 3 : 2 * (dim - 1);
    }

    /// True if one of @p faces follows a curve itself (degree 2): then those
    /// that are straight are meant to be.
    bool
    has_curved_faces(const std::vector<CollectedFace<dim>> &faces) const;

    struct Beside
    {
      unsigned int face = 0;
      unsigned int edge = 0; ///< of that face
    };

    /// What is beside facet @p f across its edge @p e; nothing where the
    /// surface ends or has a sharp edge.
    std::optional<Beside>
    neighbour(const unsigned int f, const unsigned int e) const;

    /// True if facets of another level are at the other side of edge @p e.
    bool
    is_between_levels(const unsigned int f, const unsigned int e) const
    {
      return between_levels.count(edge_keys[f][e]) > 0;
    }

    /// Half the length of facet @p f towards its edge @p e.
    double
    half_length(const unsigned int f, const unsigned int e) const
    {
      return (middle_of_edge(f, e) - centres[f]).norm();
    }

    /// Curvature of lines and quadrilaterals across edge @p e, from the angle
    /// there; not a number without a neighbour.
    double
    curvature_at(const unsigned int f, const unsigned int e) const;

  protected:
    /// Nodes nearer to a plane, over the size of the facets, lie in it.
    static constexpr double in_plane = 1e-6;

    using Key = std::vector<NodeName>; ///< nodes of an edge

    /// Of a facet: one of its nodes.
    struct Corner
    {
      unsigned int face = 0;
      unsigned int node = 0;
    };

    const FaceShape<dim>            face_shape;
    const FaceShape<dim>            shape;    ///< of the facets: of degree 1
    const std::vector<unsigned int> vertices; ///< among the nodes of a face
    const double                    least_cosine;
    std::vector<std::vector<Tensor<1, dim>>> nodes;
    std::vector<Tensor<1, dim>>              centres;
    std::vector<Tensor<1, dim>>              normals;
    std::vector<Key>                         node_keys; ///< per face
    std::vector<std::vector<Key>>            edge_keys; ///< per face
    std::map<Key, std::vector<Beside>>       edges;
    std::map<NodeName, std::vector<Corner>>  around;
    std::set<Key>                            between_levels;
    /// Normals of the symmetry planes at the nodes where the surface ends.
    std::map<NodeName, std::vector<Tensor<1, dim>>> planes;

    void
    find_edges_between_levels();

    void
    find_planes(const HeldDirections<dim>             &held_directions,
                const std::vector<CollectedFace<dim>> &faces);

    /// Of those at node @p key; nothing if there is none.
    const std::vector<Tensor<1, dim>> &
    planes_at(const NodeName &key) const;

    /// The normal of the plane that edge @p e of facet @p f ends at.
    std::optional<Tensor<1, dim>>
    plane_at_edge(const unsigned int f, const unsigned int e) const;

    std::vector<unsigned int>
    nodes_of_edge(const unsigned int e) const;

    Tensor<1, dim>
    middle_of_edge(const unsigned int f, const unsigned int e) const;

    bool
    meet_smoothly(const unsigned int f, const unsigned int g) const
    {
      return normals[f] * normals[g] >= least_cosine;
    }
  };
} // namespace stickslip

#endif
