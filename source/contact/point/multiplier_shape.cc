#include <stickslip/contact/point/multiplier_shape.h>

#include <stickslip/base/user_error.h>

namespace stickslip
{
  namespace
  {
    void
    check_quadratic_triangles(const ContactPairParameters &parameters,
                              const std::string           &path)
    {
      if (parameters.multiplier_space == MultiplierSpace::displacement_trace)
        throw UserError("'" + path +
                        "/Multiplier space = displacement trace' does not "
                        "work on tetrahedra of degree 2: the nodal weights of "
                        "a quadratic triangle vanish at its vertices. Take "
                        "'vertices' or 'automatic'.");
      if (parameters.quadrature == ContactRule::nodal)
        throw UserError("'" + path +
                        "/Quadrature = nodal' does not work on tetrahedra of "
                        "degree 2: a constant pressure has no force at the "
                        "vertices of a quadratic triangle. Take 'segments'.");
    }
  } // namespace



  template <int dim>
  FaceShape<dim>
  make_multiplier_shape(const ContactPairParameters &parameters,
                        const FaceShape<dim>        &displacement_shape,
                        const std::string           &path,
                        const CrossSection          &cross_section)
  {
    const bool is_quadratic_triangle =
      displacement_shape.is_triangle() && displacement_shape.degree() > 1;
    if (is_quadratic_triangle)
      check_quadratic_triangles(parameters, path);
    const bool is_linear =
      is_quadratic_triangle ||
      parameters.multiplier_space == MultiplierSpace::vertices ||
      (parameters.multiplier_space == MultiplierSpace::automatic &&
       cross_section.is_axisymmetric &&
       parameters.quadrature == ContactRule::segments);
    return FaceShape<dim>(is_linear ? 1 : displacement_shape.degree(),
                          displacement_shape.reference_cell());
  }



  template FaceShape<2>
  make_multiplier_shape(const ContactPairParameters &,
                        const FaceShape<2> &,
                        const std::string &,
                        const CrossSection &);
  template FaceShape<3>
  make_multiplier_shape(const ContactPairParameters &,
                        const FaceShape<3> &,
                        const std::string &,
                        const CrossSection &);
} // namespace stickslip
