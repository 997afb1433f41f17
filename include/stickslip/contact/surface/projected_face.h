#ifndef stickslip_contact_surface_projected_face_h
#define stickslip_contact_surface_projected_face_h

#include <stickslip/contact/surface/convex_cell.h>
#include <stickslip/contact/surface/surface_face.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * The plane (2D: line) on which a slave face and the master faces opposite
   * it are intersected: through the centre of the slave face, normal to it
   * there. Positions are projected along the normal (Puso and Laursen, Comput.
   * Methods Appl. Mech. Engrg. 193, 2004).
   */
  template <int dim>
  struct ProjectionPlane
  {
    Tensor<1, dim>                      origin;
    Tensor<1, dim>                      n; ///< outward normal of the slave
    std::array<Tensor<1, dim>, dim - 1> e; ///< orthonormal, in the plane

    /// Coordinates of the projection of @p x [length].
    Point<dim - 1>
    coordinates(const Tensor<1, dim> &x) const
    {
      Point<dim - 1> p;
      for (unsigned int d = 0; d < dim - 1; ++d)
        p[d] = e[d] * (x - origin);
      return p;
    }
  };



  /// The plane of a slave face. @p positions are those of its nodes.
  template <int dim>
  ProjectionPlane<dim>
  projection_plane(const SurfaceFace<dim>            &slave,
                   const FaceShape<dim>              &shape,
                   const std::vector<Tensor<1, dim>> &positions);



  /// A face that is seen from a plane: its cells between neighbouring nodes
  /// (one for degree 1, 2^(dim-1) for degree 2) as they are projected.
  template <int dim>
  struct ProjectedFace
  {
    /// As FaceShape::cells() counts them.
    boost::container::small_vector<ConvexCell<dim - 1>, 1> cells;
    /// [cell][i]: the edge from corner i to the next one (2D: corner i) moves
    /// over the slave face, and no neighbour takes over what it passes.
    std::vector<std::vector<bool>> moving_edges;
    Point<dim - 1>                 low; ///< of all cells
    Point<dim - 1>                 high;
  };

  /// False if the projection of a face with @p n_nodes at @p positions has no
  /// point in common with the box around @p face.
  template <int dim>
  bool
  may_meet(const ProjectedFace<dim>          &face,
           const ProjectionPlane<dim>        &plane,
           const std::vector<Tensor<1, dim>> &positions,
           const unsigned int                 n_nodes);

  /// The map from a cell of a projected face to parametric coordinates that
  /// takes the corners to their nodes: that of the face itself, if it has no
  /// other nodes. Collapsed cells go to their centre, in badly distorted ones
  /// three corners count.
  template <int dim>
  class ParametricMap
  {
  public:
    ParametricMap(const FaceShape<dim>     &shape,
                  const ProjectedFace<dim> &face,
                  const unsigned int        cell);

    Point<dim - 1>
    at(const Point<dim - 1> &p) const;

  private:
    /// With coordinates s of the corners at 0 and 1, places in the plane are
    /// corner + edges * s + twist * s_0 s_1, parametric ones first + extent *
    /// s.
    Point<dim - 1>     corner, first;
    Tensor<2, dim - 1> edges, inverse_edges, extent;
    Tensor<1, dim - 1> twist; ///< zero for intervals and triangles
  };

  template <int dim>
  ProjectedFace<dim>
  project(const FaceShape<dim>              &shape,
          const std::vector<Tensor<1, dim>> &positions,
          const ProjectionPlane<dim>        &plane);
} // namespace stickslip

#endif
