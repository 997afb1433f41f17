#ifndef stickslip_contact_surface_facet_rise_h
#define stickslip_contact_surface_facet_rise_h

#include <stickslip/contact/surface/faceted_surface.h>

#include <vector>

namespace stickslip
{
  /**
   * Sets SurfaceFace::rise of faces that are straight where nothing is
   * deformed: how far the smooth surface that they are the facets of is outside
   * of them, from the angles between neighbours. Exact for circles (with lines,
   * and along the edges of quadrilaterals that follow them), whatever the sizes
   * of the facets.
   *
   * The curvature of a facet is the mean of those at its ends, from the angles
   * there. What is flat beside a fillet stays flat, so does a chamfer of one
   * facet, and a flat facet between curved ones. Where the surface ends at a
   * symmetry plane (@p held_directions), normal to it, the mirror image is the
   * neighbour; at other ends and at edges of more than @p sharpest_turn
   * [radian] the curvature goes on as it has changed before, if it is alike
   * there. Nothing is done if faces follow curves themselves (degree 2).
   * @p faces are those of a surface, ghosts included, sorted. Collective.
   */
  template <int dim>
  void
  find_rises(const FaceShape<dim>            &shape,
             const double                     sharpest_turn,
             const HeldDirections<dim>       &held_directions,
             const MPI_Comm                  &communicator,
             std::vector<CollectedFace<dim>> &faces);

  /// True if the smooth surface behind facets is inside of them in a tenth of
  /// what is curved. Collective.
  template <int dim>
  bool
  is_partly_concave(const std::vector<CollectedFace<dim>> &faces,
                    const MPI_Comm                        &communicator);

  /// The rise at @p xi [length]; 0 of faces that have none.
  template <int dim>
  double
  rise_at(const SurfaceFace<dim> &face, const Point<dim - 1> &xi);

  /// What the rise of two facets adds to how far the @p slave is behind the
  /// @p master, at xi and eta [length].
  template <int dim>
  double
  rise_between(const SurfaceFace<dim> &slave,
               const Point<dim - 1>   &xi,
               const SurfaceFace<dim> &master,
               const Point<dim - 1>   &eta);

  /// The derivative of rise_at() with respect to xi.
  template <int dim>
  Tensor<1, dim - 1>
  rise_gradient(const SurfaceFace<dim> &face, const Point<dim - 1> &xi);
} // namespace stickslip

#endif
