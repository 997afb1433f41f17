#ifndef stickslip_contact_surface_normal_projection_h
#define stickslip_contact_surface_normal_projection_h

#include <stickslip/contact/surface/master_geometry.h>

#include <array>

namespace stickslip
{
  /**
   * How xi may move: 1 along each direction inside a face; on an edge the
   * direction of the edge, as (0, 1), or (-1, 1) for the slanting edge of a
   * triangle; 0 at a corner.
   */
  template <int dim>
  using EdgeMotion = std::array<int, dim - 1>;

  template <int dim>
  EdgeMotion<dim>
  everywhere()
  {
    EdgeMotion<dim> free;
    free.fill(1);
    return free;
  }

  /// Where a slave point lies over a master face.
  template <int dim>
  struct Projection
  {
    bool            found = false; ///< Newton converged / an edge point exists
    Point<dim - 1>  xi;
    EdgeMotion<dim> free{};
    double          distance = 0.; ///< |x_s - xbar|
    /// Part of x_s - xbar that is not along the normal (0 inside the face).
    double overshoot = 0.;
  };

  /**
   * Projects @p x_s on a master face along its normal field,
   *
   *   x_s = xbar(xi) + d_n n(xi),
   *
   * by Newton's method in (xi, d_n). With facet normals this is the closest
   * point projection; with smoothed normals the projection is continuous across
   * facets. `found` only if xi is inside the face, or outside by at most the
   * fraction @p overlap of the face.
   */
  template <int dim>
  Projection<dim>
  project_on_face(const SurfaceFace<dim>         &face,
                  const MasterConfiguration<dim> &configuration,
                  const FaceShape<dim>           &shape,
                  const Tensor<1, dim>           &x_s,
                  const double                    overlap);

  /// Closest point of @p x_s on the edges and corners of a master face.
  template <int dim>
  Projection<dim>
  project_on_boundary_of_face(const SurfaceFace<dim>         &face,
                              const MasterConfiguration<dim> &configuration,
                              const FaceShape<dim>           &shape,
                              const Tensor<1, dim>           &x_s);
} // namespace stickslip

#endif
