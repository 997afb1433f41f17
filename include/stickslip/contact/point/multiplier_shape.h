#ifndef stickslip_contact_point_multiplier_shape_h
#define stickslip_contact_point_multiplier_shape_h

#include <stickslip/contact/point/contact_parameters.h>
#include <stickslip/contact/surface/face_shape.h>

#include <stickslip/mesh/cross_section.h>

#include <string>

namespace stickslip
{
  /**
   * The shape functions of the multipliers on faces with the given ones of the
   * displacement. On quadratic triangles they are linear: the integrals of the
   * quadratic functions of the vertices vanish there, so that multipliers with
   * these functions have no weight, and a constant pressure is not made of
   * forces at the vertices. Throws UserError about the pair at @p path where
   * the parameters want that. In a section of bodies of revolution the same is
   * true of lines that end on the axis, so that `automatic` is linear there
   * with segments.
   */
  template <int dim>
  FaceShape<dim>
  make_multiplier_shape(const ContactPairParameters &parameters,
                        const FaceShape<dim>        &displacement_shape,
                        const std::string           &path,
                        const CrossSection          &cross_section = {});
} // namespace stickslip

#endif
