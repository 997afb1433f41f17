#include <stickslip/solid/rigid_motion.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace stickslip
{
  template <int dim>
  RigidMotion<dim>::RigidMotion(const BoundaryConditionParameters &parameters,
                                const std::string                 &path)
  {
    if (!parameters.translation.empty())
      translation =
        std::make_shared<SpaceTimeFunction<dim>>(parameters.translation,
                                                 dim,
                                                 path + "/Translation");
    angle = std::make_shared<SpaceTimeFunction<dim>>(parameters.rotation_angle,
                                                     1,
                                                     path + "/Rotation angle");

    axis[2] = 1.;
    if (dim == 3)
      axis = vector_from_parameter<3>(parameters.rotation_axis,
                                      path + "/Rotation axis");
    if (axis.norm() == 0.)
      throw UserError(path + "/Rotation axis has no length.");
    axis /= axis.norm();

    if (!parameters.rotation_centre.empty())
      centre =
        Point<dim>(vector_from_parameter<dim>(parameters.rotation_centre,
                                              path + "/Rotation centre"));
  }



  template <int dim>
  Tensor<1, dim>
  RigidMotion<dim>::displacement(const Point<dim> &reference_position,
                                 const double      time) const
  {
    Tensor<1, dim> u;
    if (translation)
      u = translation->vector(centre, time);
    if (!angle)
      return u;

    // Rodrigues: (Q - I) r = sin(phi) a x r + (1 - cos(phi)) a x (a x r)
    const double phi = angle->value(centre, time) * numbers::PI / 180.;
    Tensor<1, 3> r;
    for (unsigned int d = 0; d < dim; ++d)
      r[d] = reference_position[d] - centre[d];
    const Tensor<1, 3> a_x_r = cross_product_3d(axis, r);
    const Tensor<1, 3> rotated =
      std::sin(phi) * a_x_r +
      (1. - std::cos(phi)) * cross_product_3d(axis, a_x_r);
    for (unsigned int d = 0; d < dim; ++d)
      u[d] += rotated[d];
    return u;
  }



  template class RigidMotion<2>;
  template class RigidMotion<3>;
} // namespace stickslip
