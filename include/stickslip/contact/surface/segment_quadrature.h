#ifndef stickslip_contact_surface_segment_quadrature_h
#define stickslip_contact_surface_segment_quadrature_h

#include <stickslip/contact/surface/projected_face.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/base/quadrature.h>

namespace stickslip
{
  using namespace dealii;

  /**
   * Where the integration points of a segment are. Exact for products of two
   * shape functions where both faces are parallelograms or straight triangles,
   * in 2D on slave edges that are straight where nothing is deformed, before
   * master edges that are straight; of a higher order where they are not, as
   * shape functions then are no polynomials.
   *
   * More hangs on that than the accuracy of the integrals: their derivative is
   * that of the exact integral, in which the motion of the borders between
   * segments cancels. Newton's method converges as well as the rule does.
   */
  template <int dim>
  class SegmentQuadrature
  {
  public:
    /// At least @p order points per direction.
    SegmentQuadrature(const FaceShape<dim> &slave_shape,
                      const FaceShape<dim> &master_shape,
                      const unsigned int    order,
                      const CrossSection   &cross_section);

    /// False: points are spread over the plane of projection. True: over the
    /// parameter of the slave edge, in which places in the plane are
    /// polynomials while the opposite is not true. For edges of degree 1 both
    /// are the same.
    bool
    is_parametric() const
    {
      return parametric;
    }

    /// Points and weights on the unit simplex, for the simplices of the
    /// intersection of cell @p i of @p slave with cell @p j of @p master.
    const Quadrature<dim - 1> &
    rule(const ProjectedFace<dim> &slave,
         const unsigned int        i,
         const ProjectedFace<dim> &master,
         const unsigned int        j) const;

  private:
    const bool                parametric;
    const bool                is_never_exact;
    const Quadrature<dim - 1> exact_rule, other_rule;
  };
} // namespace stickslip

#endif
