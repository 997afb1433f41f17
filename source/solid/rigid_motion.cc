#include <stickslip/solid/rigid_motion.h>

#include <stickslip/base/axes_across.h>
#include <stickslip/base/user_error.h>

#include <stickslip/solid/direction_parameters.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <vector>

namespace stickslip
{
  template <int dim>
  RigidMotion<dim>::RigidMotion(
    const BoundaryConditionParameters      &parameters,
    const std::shared_ptr<const Amplitude> &amplitude,
    const std::string                      &path)
    : path(path)
  {
    const auto law = [&](const std::string &text,
                         const unsigned int n,
                         const std::string &name,
                         const bool         may_be_free) -> Law {
      if (text.empty())
        return nullptr;
      auto function = std::make_shared<SpaceTimeFunction<dim>>(
        text, n, path + "/" + name, may_be_free);
      function->multiply_by(amplitude);
      return function;
    };
    has_rotation_vector =
      dim == 3 &&
      Utilities::split_string_list(parameters.rotation_angle, ";").size() > 1;
    const unsigned int n = has_rotation_vector ? 3 : 1;
    translation = law(parameters.translation, dim, "Translation", true);
    angle       = law(parameters.rotation_angle, n, "Rotation angle", true);
    force       = law(parameters.force, dim, "Force", false);
    torque      = law(parameters.torque, n, "Torque", false);
    for (unsigned int d = 0; d < dim && translation; ++d)
      free_components[d] = translation->is_free(d);
    for (unsigned int k = 0; k < n && angle; ++k)
      free_components[dim + k] = angle->is_free(k);

    Tensor<1, 3> axis;
    std::tie(axis, centre) =
      axis_of<dim>(parameters.rotation_axis, parameters.rotation_centre, path);
    axes[0] = axis;
    if constexpr (dim == 3)
      {
        const auto across = axes_across(axis);
        std::copy(across.begin(), across.end(), axes.begin() + 1);
        for (unsigned int k = 0; has_rotation_vector && k < 3; ++k)
          axes[k] = Point<3>::unit_vector(k);
      }
    read_stiffnesses(parameters);
    check(parameters);
  }



  template <int dim>
  void
  RigidMotion<dim>::read_stiffnesses(
    const BoundaryConditionParameters &parameters)
  {
    const auto read = [this](const std::string &text,
                             const unsigned int n,
                             const std::string &name,
                             double            *values) {
      if (text.empty())
        return;
      const std::vector<std::string> parts =
        split_components(text, n, path + "/" + name);
      for (unsigned int i = 0; i < n; ++i)
        try
          {
            values[i] = Utilities::string_to_double(parts[i]);
            AssertThrow(values[i] >= 0., ExcInternalError());
          }
        catch (const ExceptionBase &)
          {
            throw UserError(
              path + "/" + name + " is '" + text + "', but has to be " +
              (n == 1 ? "a number that is not negative."
                      : std::to_string(n) + " numbers that are not negative, "
                                            "separated by ';'."));
          }
    };
    read(parameters.translation_stiffness,
         dim,
         "Translation stiffness",
         stiffnesses.data());
    read(parameters.rotation_stiffness,
         has_rotation_vector ? 3 : 1,
         "Rotation stiffness",
         stiffnesses.data() + dim);
  }



  template <int dim>
  void
  RigidMotion<dim>::check(const BoundaryConditionParameters &parameters) const
  {
    const auto refuse_unless_free = [&](const std::string &name,
                                        const bool         is_given,
                                        const unsigned int first,
                                        const unsigned int last,
                                        const std::string &motion) {
      if (is_given && std::count(free_components.begin() + first,
                                 free_components.begin() + last,
                                 true) == 0)
        throw UserError(path + "/" + name + " is given, but no component of '" +
                        motion + "' is 'free': the force is a result then.");
    };
    refuse_unless_free("Force", force != nullptr, 0, dim, "Translation");
    refuse_unless_free("Translation stiffness",
                       !parameters.translation_stiffness.empty(),
                       0,
                       dim,
                       "Translation");
    refuse_unless_free(
      "Torque", torque != nullptr, dim, n_components, "Rotation angle");
    refuse_unless_free("Rotation stiffness",
                       !parameters.rotation_stiffness.empty(),
                       dim,
                       n_components,
                       "Rotation angle");
    for (unsigned int c = 0; c < n_components; ++c)
      if (stiffnesses[c] > 0. && !free_components[c])
        throw UserError(
          path + (c < dim ? "/Translation stiffness" : "/Rotation stiffness") +
          " is given for a component that is not 'free'.");
    if (has_free_rotation() && parameters.rotation_centre.empty())
      throw UserError(path +
                      "/Rotation centre is empty, but with a free rotation it "
                      "says where 'Force' acts.");
  }



  template <int dim>
  bool
  RigidMotion<dim>::has_free_components() const
  {
    return std::count(free_components.begin(), free_components.end(), true) > 0;
  }



  template <int dim>
  bool
  RigidMotion<dim>::has_free_rotation() const
  {
    return std::count(free_components.begin() + dim,
                      free_components.end(),
                      true) > 0;
  }



  template <int dim>
  bool
  RigidMotion<dim>::all_rotations_are_free() const
  {
    return std::count(free_components.begin() + dim,
                      free_components.end(),
                      false) == 0;
  }



  template <int dim>
  double
  RigidMotion<dim>::rotation_value(const unsigned int component,
                                   const double       time) const
  {
    const unsigned int k = component - dim;
    return !angle || (k > 0 && !has_rotation_vector)
             ? 0.
             : angle->value(centre, time, k) * numbers::PI / 180.;
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
    double       phi  = rotation_value(dim, time);
    Tensor<1, 3> axis = axes[0];
    if (has_rotation_vector)
      {
        Tensor<1, 3> theta;
        for (unsigned int c = dim; c < n_components; ++c)
          theta += rotation_value(c, time) * rotation_axis(c);
        phi = theta.norm();
        if (phi > 0.)
          axis = theta / phi;
      }
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



  template <int dim>
  void
  RigidMotion<dim>::prescribe(const double time, RigidState<dim> &state) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!is_free(d))
        state.translation[d] =
          translation ? translation->value(centre, time, d) : 0.;
    if (all_rotations_are_free())
      return;
    std::vector<Tensor<1, 3>> held_axes;
    std::vector<double>       values;
    for (unsigned int c = dim; c < n_components; ++c)
      if (!is_free(c))
        {
          held_axes.push_back(rotation_axis(c));
          values.push_back(rotation_value(c, time));
        }
    Tensor<1, 3> theta =
      has_free_rotation()
        ? nearest_branch(state.rotation.vector(), held_axes, values)
        : Tensor<1, 3>();
    for (unsigned int k = 0; k < values.size(); ++k)
      theta += (values[k] - theta * held_axes[k]) * held_axes[k];
    state.rotation = FiniteRotation::from_vector(theta);
  }



  template <int dim>
  Tensor<1, 3>
  RigidMotion<dim>::spin(const unsigned int     component,
                         const RigidState<dim> &state) const
  {
    return all_rotations_are_free()
             ? rotation_axis(component)
             : spin_of_rotation_vector(state.rotation.vector()) *
                 rotation_axis(component);
  }



  template <int dim>
  double
  RigidMotion<dim>::load(const unsigned int component, const double time) const
  {
    if (component < dim)
      return force ? force->value(centre, time, component) : 0.;
    const unsigned int k = component - dim;
    return torque && (k == 0 || has_rotation_vector)
             ? torque->value(centre, time, k)
             : 0.;
  }



  template <int dim>
  void
  RigidMotion<dim>::check_forces(const double time) const
  {
    for (unsigned int c = 0; c < n_components; ++c)
      if (!is_free(c) && load(c, time) != 0.)
        {
          std::ostringstream text;
          text << path << (c < dim ? "/Force" : "/Torque") << ": its component "
               << (c < dim ? c : c - dim) + 1 << " is " << load(c, time)
               << " at time " << time << ", but that component of "
               << (c < dim ? "'Translation'" : "'Rotation angle'")
               << " is not 'free'. Set it to 0: it is a result.";
          throw UserError(text.str());
        }
  }



  template <int dim>
  RigidState<dim>
  RigidMotion<dim>::moved(const unsigned int     component,
                          const double           step,
                          const RigidState<dim> &state) const
  {
    RigidState<dim> result = state;
    if (component < dim)
      {
        result.translation[component] += step;
        return result;
      }
    const Tensor<1, 3> change = step * rotation_axis(component);
    result.rotation =
      all_rotations_are_free()
        ? FiniteRotation::from_vector(change).after(state.rotation)
        : FiniteRotation::from_vector(state.rotation.vector() + change);
    return result;
  }



  template <int dim>
  double
  RigidMotion<dim>::driving_force(const unsigned int     component,
                                  const double           time,
                                  const RigidState<dim> &state) const
  {
    if (component < dim)
      return load(component, time);
    Tensor<1, 3> moment;
    for (unsigned int c = dim; c < n_components; ++c)
      moment += load(c, time) * rotation_axis(c);
    return moment * spin(component, state);
  }



  template <int dim>
  double
  RigidMotion<dim>::spring_force(const unsigned int     component,
                                 const RigidState<dim> &state) const
  {
    if (component < dim)
      return -stiffness(component) * state.translation[component];
    const Tensor<1, 3> theta = state.rotation.vector();
    Tensor<1, 3>       torque_of_springs; // conjugate to the rotation vector
    for (unsigned int c = dim; c < n_components; ++c)
      torque_of_springs -=
        stiffness(c) * (theta * rotation_axis(c)) * rotation_axis(c);
    if (all_rotations_are_free() && torque_of_springs.norm_square() > 0.)
      torque_of_springs =
        invert(transpose(spin_of_rotation_vector(theta))) * torque_of_springs;
    return torque_of_springs * rotation_axis(component);
  }



  template class RigidMotion<2>;
  template class RigidMotion<3>;
} // namespace stickslip
