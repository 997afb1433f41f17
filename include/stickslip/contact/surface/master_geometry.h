#ifndef stickslip_contact_surface_master_geometry_h
#define stickslip_contact_surface_master_geometry_h

#include <stickslip/contact/surface/surface_face.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * A master face in one configuration: nodal positions of its stencil and, if
   * its normals are smoothed, the averaged unit normals of its own nodes.
   */
  template <int dim>
  struct MasterConfiguration
  {
    std::vector<Tensor<1, dim>> positions;     ///< of the stencil nodes
    std::vector<Tensor<1, dim>> nodal_normals; ///< empty: facet normals
  };

  /// Computes the averaged nodal normals of @p face from its positions.
  template <int dim>
  void
  update_nodal_normals(const SurfaceFace<dim>   &face,
                       MasterConfiguration<dim> &configuration);

  /**
   * Derivative of the averaged normal of own node @p j with respect to the
   * position of every stencil node (dim x dim each), for the consistent
   * tangent.
   */
  template <int dim>
  void
  nodal_normal_derivatives(const SurfaceFace<dim>         &face,
                           const MasterConfiguration<dim> &configuration,
                           const unsigned int              j,
                           std::vector<Tensor<2, dim>>    &derivative);

  /**
   * Geometry of a master face at one parametric point: position, tangents
   * a_alpha, second derivatives, unit normal into the master body and its
   * derivatives along xi (doc/theory.md, section 5).
   */
  template <int dim>
  struct MasterPoint
  {
    FaceShapeValues<dim>                                     shape;
    Tensor<1, dim>                                           x;
    std::array<Tensor<1, dim>, dim - 1>                      a;
    std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> x_ab;
    Tensor<1, dim>                                           n;
    std::array<Tensor<1, dim>, dim - 1>                      n_a;
    std::array<Tensor<1, dim>, dim - 1> a_dual; ///< contravariant tangents
    double averaged_normal_length = 1.;         ///< |sum M_j n_j| if smoothed
  };

  /**
   * Fills @p point where its shape functions are known: those of the first
   * @p n_nodes nodes, which are at @p positions. The normal is that of the
   * surface, times @p orientation.
   */
  template <int dim>
  void
  evaluate_curved_point(const std::vector<Tensor<1, dim>> &positions,
                        const unsigned int                 n_nodes,
                        const double                       orientation,
                        MasterPoint<dim>                  &point);

  template <int dim>
  void
  evaluate_master_point(const SurfaceFace<dim>         &face,
                        const MasterConfiguration<dim> &configuration,
                        const FaceShape<dim>           &shape,
                        const Point<dim - 1>           &xi,
                        MasterPoint<dim>               &point);
} // namespace stickslip

#endif
