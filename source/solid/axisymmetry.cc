#include <stickslip/solid/axisymmetry.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/periodic_conditions.h>

#include <deal.II/base/utilities.h>

#include <memory>
#include <sstream>

namespace stickslip
{
  namespace
  {
    bool
    is_zero(const std::string &text)
    {
      try
        {
          return Utilities::string_to_double(Utilities::trim(text)) == 0.;
        }
      catch (const ExceptionBase &)
        {
          return false;
        }
    }



    /// The radial component of a rigid motion or of its force has to be 0.
    void
    check_radial_component(const std::string &text, const std::string &path)
    {
      const auto parts = Utilities::split_string_list(text, ";");
      if (!parts.empty() && !is_zero(parts.front()))
        throw UserError(path + " is '" + text +
                        "', but with 'Axisymmetric = true' a rigid body can "
                        "move along y alone: the component along x, the "
                        "radius, has to be 0. (A radial displacement is a "
                        "condition of the type displacement.)");
    }
  } // namespace



  void
  check_is_axisymmetric(const BoundaryConditionParameters &parameters,
                        const std::string                 &path)
  {
    const std::string model = ", but with 'Axisymmetric = true' ";
    if (parameters.components == VectorComponents::cylindrical)
      throw UserError(path + "/Components is cylindrical" + model +
                      "x is the radius already. Take Cartesian.");
    if (parameters.type == BoundaryConditionType::periodic &&
        periodic_axis<2>(parameters, path) == 0)
      throw UserError(path + "/Direction is '" + parameters.direction + "'" +
                      model +
                      "x is the radius, along which nothing repeats. Take y.");
    if (parameters.type == BoundaryConditionType::cyclic_symmetry)
      throw UserError(path + "/Type is 'cyclic symmetry'" + model +
                      "the bodies are the same all around already. Remove it.");
    if (parameters.type != BoundaryConditionType::rigid_motion &&
        parameters.type != BoundaryConditionType::distributed_force)
      return;
    if (!parameters.rotation_angle.empty() &&
        !is_zero(parameters.rotation_angle))
      throw UserError(path + "/Rotation angle is '" +
                      parameters.rotation_angle + "'" + model +
                      "a rigid body cannot rotate. Remove it.");
    if (!parameters.torque.empty())
      throw UserError(path + "/Torque is given" + model +
                      "nothing can rotate. Remove it.");
    check_radial_component(parameters.translation, path + "/Translation");
    check_radial_component(parameters.force, path + "/Force");
  }



  template <int dim>
  std::vector<PrescribedDisplacement<dim>>
  conditions_on_axis(const Bodies &bodies)
  {
    std::vector<PrescribedDisplacement<dim>> conditions;
    if (!bodies.cross_section.is_axisymmetric)
      return conditions;
    std::ostringstream on_axis;
    on_axis.precision(17);

    on_axis << "x <= " << bodies.cross_section.radius_of_axis;
    for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
      if (bodies.bodies[b].reaches_axis && !bodies.bodies[b].is_rigid)
        {
          const std::string           path = "Bodies/" + bodies.bodies[b].name;
          PrescribedDisplacement<dim> condition;
          condition.name = "(axis of body " + bodies.bodies[b].name + ")";
          condition.type = BoundaryConditionType::displacement;
          condition.body = b;
          condition.value =
            std::make_shared<SpaceTimeFunction<dim>>("0; free", 2, path, true);
          condition.where = std::make_shared<SpaceTimeFunction<dim>>(
            on_axis.str(), 1, path, false, false);
          condition.is_of_axis = true;
          conditions.push_back(condition);
        }
    return conditions;
  }

  template std::vector<PrescribedDisplacement<2>>
  conditions_on_axis(const Bodies &);
  template std::vector<PrescribedDisplacement<3>>
  conditions_on_axis(const Bodies &);
} // namespace stickslip
