#ifndef stickslip_contact_surface_faceted_triangles_h
#define stickslip_contact_surface_faceted_triangles_h

#include <stickslip/contact/surface/faceted_surface.h>

#include <vector>

namespace stickslip
{
  /// A surface of triangles: whatever lies around them tells how it is curved.
  template <int dim>
  class FacetedTriangles : public FacetedSurface<dim>
  {
  public:
    using FacetedSurface<dim>::FacetedSurface;

    /**
     * Rises of a triangle over the middles of its edges: those of the
     * quadratic surface through its vertices that fits best to the vertices of
     * the triangles around it. Where the normals at the ends of an edge say
     * that it is flat, or much less curved, they are right.
     */
    std::vector<double>
    rises_of(const unsigned int f) const;

  private:
    Tensor<1, dim>
    normal_at_node(const unsigned int f, const unsigned int j) const;

    bool
    goes_on_beyond(const unsigned int    f,
                   const unsigned int    j,
                   const Tensor<1, dim> &way) const;

    double
    rise_of_normals(const unsigned int f, const unsigned int e) const;

    std::vector<Tensor<1, dim>>
    vertices_around(const unsigned int f) const;

    std::vector<double>
    fitted_rises(const unsigned int f) const;
  };
} // namespace stickslip

#endif
