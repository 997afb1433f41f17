#ifndef stickslip_contact_surface_mortar_segments_h
#define stickslip_contact_surface_mortar_segments_h

#include <stickslip/contact/surface/segment_quadrature.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// An integration point: the same place on a slave and on a master face.
  template <int dim>
  struct SegmentPoint
  {
    Point<dim - 1> xi;          ///< on the slave face
    Point<dim - 1> eta;         ///< on the master face
    unsigned int   master = 0;  ///< number of that face
    unsigned int   chart  = 0;  ///< of a rigid tool: that of eta
    double         weight = 0.; ///< undeformed slave area
  };



  /// A point of the border of a segment that moves over the slave face, with
  /// the straight line between two nodes: of the master where its surface ends,
  /// of either face where they are curved.
  template <int dim>
  struct SegmentEnd
  {
    Point<dim - 1> xi;
    Point<dim - 1> eta;
    unsigned int   master = 0;
    double         weight = 0.; ///< undeformed slave area per motion
    Tensor<1, dim> outward;     ///< unit normal of the border, in the plane
    bool           on_slave = false;     ///< the line is one of the slave face
    std::array<unsigned int, 2> nodes{}; ///< of that face
    double                      share = 0.; ///< of the second of them
  };



  /**
   * Integration over the intersection of a slave face with a master face, both
   * projected on the plane of the slave face: polygons that are cut into
   * triangles (2D: intervals). Areas are those of the body of revolution, if
   * the model is a section of one.
   */
  template <int dim>
  class SegmentRule
  {
  public:
    /// At least @p order points per direction.
    SegmentRule(const FaceShape<dim> &slave_shape,
                const FaceShape<dim> &master_shape,
                const unsigned int    order,
                const CrossSection   &cross_section = {});

    /// One side of an intersection: a face, where its nodes are, and how it
    /// looks from the plane.
    struct Side
    {
      const std::vector<Tensor<1, dim>> &positions;
      const ProjectedFace<dim>          &projected;
    };

    /// Appends the points of the intersection to @p points, with the number
    /// @p master. @p reference are the undeformed nodes of the slave face.
    void
    add_points(const ProjectionPlane<dim>     &plane,
               const Side                     &slave,
               const std::vector<Point<dim>>  &reference,
               const Side                     &opposite,
               const unsigned int              master,
               std::vector<SegmentPoint<dim>> &points) const;

    /// Appends the points of those borders of the intersection that move
    /// (ProjectedFace::moving_edges).
    void
    add_ends(const ProjectionPlane<dim>    &plane,
             const Side                    &slave,
             const std::vector<Point<dim>> &reference,
             const Side                    &opposite,
             const unsigned int             master,
             std::vector<SegmentEnd<dim>>  &ends) const;

    const FaceShape<dim> &
    slave_face_shape() const
    {
      return slave_shape;
    }

    const FaceShape<dim> &
    master_face_shape() const
    {
      return master_shape;
    }

  private:
    const FaceShape<dim>         slave_shape;
    const FaceShape<dim>         master_shape;
    const CrossSection           cross_section;
    const SegmentQuadrature<dim> quadrature;
    const Quadrature<dim - 2>    edge_rule;

    /// Parametric coordinates of the point of a face above @p p, from a first
    /// guess; false if there is none.
    bool
    find_above(const FaceShape<dim>              &shape,
               const Point<dim - 1>              &p,
               const ProjectionPlane<dim>        &plane,
               const std::vector<Tensor<1, dim>> &positions,
               Point<dim - 1>                    &xi,
               FaceShapeValues<dim>              &values,
               double                            &area_ratio) const;
  };
} // namespace stickslip

#endif
