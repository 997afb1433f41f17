#include <stickslip/solid/rigid_motion.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <tuple>

namespace stickslip
{
  template <int dim>
  RigidMotion<dim>::RigidMotion(
    const BoundaryConditionParameters      &parameters,
    const std::shared_ptr<const Amplitude> &amplitude,
    const std::string                      &path)
  {
    const auto law = [&](const std::string &text,
                         const unsigned int n_components,
                         const std::string &name) {
      auto function =
        std::make_shared<SpaceTimeFunction<dim>>(text,
                                                 n_components,
                                                 path + "/" + name);
      function->multiply_by(amplitude);
      return function;
    };
    if (!parameters.translation.empty())
      translation = law(parameters.translation, dim, "Translation");
    angle = law(parameters.rotation_angle, 1, "Rotation angle");
    std::tie(axis, centre) = axis_of<dim>(parameters, path);
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
