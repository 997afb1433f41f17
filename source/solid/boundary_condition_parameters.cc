#include <stickslip/solid/boundary_condition_parameters.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/direction_parameters.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <cmath>

namespace stickslip
{
  const Choices<BoundaryConditionType> &
  all_boundary_condition_types()
  {
    static const Choices<BoundaryConditionType> choices = {
      {"displacement", BoundaryConditionType::displacement},
      {"symmetry", BoundaryConditionType::symmetry},
      {"rigid motion", BoundaryConditionType::rigid_motion},
      {"traction", BoundaryConditionType::traction},
      {"pressure", BoundaryConditionType::pressure},
      {"follower pressure", BoundaryConditionType::follower_pressure},
      {"spring", BoundaryConditionType::spring},
      {"body force", BoundaryConditionType::body_force},
      {"distributed force", BoundaryConditionType::distributed_force},
      {"periodic", BoundaryConditionType::periodic},
      {"cyclic symmetry", BoundaryConditionType::cyclic_symmetry},
      {"pretension", BoundaryConditionType::pretension}};
    return choices;
  }



  namespace
  {
    const Choices<VectorComponents> &
    all_components()
    {
      static const Choices<VectorComponents> choices = {
        {"Cartesian", VectorComponents::cartesian},
        {"cylindrical", VectorComponents::cylindrical}};
      return choices;
    }
  } // namespace



  void
  BoundaryConditionParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Body", body, "The body's name.", Patterns::Anything());
    prm.add_parameter("Boundary",
                      boundary,
                      "The body's boundary ids or names. Empty for the whole "
                      "body (displacement, rigid motion, body force).");
    add_choice(
      prm,
      "Type",
      type,
      all_boundary_condition_types(),
      "What is prescribed. 'displacement': Value. 'symmetry': no displacement "
      "normal to the plane boundary. 'rigid motion': Translation and Rotation "
      "angle, or Force and Torque where these are free. "
      "'traction': force per reference area, Value. 'pressure': along the "
      "reference normal per reference area, Value. 'follower pressure': along "
      "the current normal per current area, Value. 'spring': force per "
      "reference area, Stiffness times the displacement along Direction. 'body "
      "force': force per reference volume, Value. 'distributed force': Force "
      "and Torque at Rotation centre, as tractions that are linear over the "
      "boundary and do not stiffen it. 'periodic': the "
      "displacements on Boundary and Second boundary are equal. 'cyclic "
      "symmetry': those on Second boundary are those on Boundary, turned about "
      "Rotation axis through Rotation centre from one to the other; a whole "
      "number of such sectors makes a full turn. 'pretension': "
      "these are the "
      "two sides of a plane cut through a bolt, with the same nodes; Force "
      "draws them over each other, and from Locked from on this stays.");
    prm.add_parameter(
      "Value",
      value,
      "Expressions of x, y, z (reference position) and t (load time): one per "
      "component, separated by ';', where 'free' leaves a component of a "
      "displacement free; one for a pressure, greater than zero if it "
      "compresses.",
      Patterns::Anything());
    prm.add_parameter("Where",
                      where,
                      "Restricts a displacement or rigid motion to the nodes "
                      "where this expression of x, y, z is not zero, for "
                      "example 'abs(x-40) < 1e-6'. Empty: no restriction.",
                      Patterns::Anything());
    prm.add_parameter("Direction",
                      direction,
                      "Of a spring: x, y, z or a vector 'a, b, c' (of any "
                      "length); empty for all directions. Of a periodic "
                      "condition: the axis that joins the two boundaries.",
                      Patterns::Anything());
    prm.add_parameter("Stiffness",
                      stiffness,
                      "Of a spring: force per reference area and displacement.",
                      Patterns::Double(0.));
    prm.add_parameter("Translation",
                      translation,
                      "Of a rigid motion: expressions of t, separated by ';', "
                      "of the displacement of Rotation centre; 'free' where it "
                      "is a result. Empty: none.",
                      Patterns::Anything());
    prm.add_parameter("Rotation angle",
                      rotation_angle,
                      "Of a rigid motion: expression of t, in degrees, or "
                      "'free', about Rotation axis; in 3D also three of them, "
                      "separated by ';': the components of the rotation vector "
                      "along x, y, z.",
                      Patterns::Anything());
    prm.add_parameter("Force",
                      force,
                      "Of a rigid motion with free components of Translation: "
                      "the force at Rotation centre, expressions of t, "
                      "separated by ';'. Empty: none. Of a distributed force: "
                      "the same. Of a pretension: the tension in the whole "
                      "bolt, one expression of t.",
                      Patterns::Anything());
    prm.add_parameter("Torque",
                      torque,
                      "Of a rigid motion with free components of Rotation "
                      "angle: as many expressions of t. Of a distributed "
                      "force: one in 2D, three in 3D. Empty: none.",
                      Patterns::Anything());
    prm.add_parameter("Translation stiffness",
                      translation_stiffness,
                      "Of a rigid motion: springs along free components, "
                      "numbers (force per displacement) separated by ';'.",
                      Patterns::Anything());
    prm.add_parameter("Rotation stiffness",
                      rotation_stiffness,
                      "Of a rigid motion: springs against free rotations, as "
                      "many numbers (torque per radian) as Rotation angle.",
                      Patterns::Anything());
    prm.add_parameter(
      "Rotation axis",
      rotation_axis,
      "Of a rigid motion, of cyclic symmetry and of cylindrical "
      "components in 3D: x, y, z or a vector 'a, b, c'.",
      Patterns::Anything());
    prm.add_parameter(
      "Rotation centre",
      rotation_centre,
      "Of a rigid motion, of cyclic symmetry and of cylindrical "
      "components: a point on the axis in the reference configuration, and "
      "what Translation, Force and Torque refer to. Empty: the "
      "origin, but not with a free rotation.",
      Patterns::Anything());
    prm.add_parameter(
      "Second boundary",
      second_boundary,
      "Of a periodic condition and of cyclic symmetry: the other "
      "boundary. Of a pretension: the other side of the cut.");
    prm.add_parameter("Second body",
                      second_body,
                      "Of a pretension: the body of Second boundary. Empty: "
                      "Body.",
                      Patterns::Anything());
    prm.add_parameter("Amplitude",
                      amplitude,
                      "Name of a section of Amplitudes: a factor over the load "
                      "time, by which Value, or Translation, Rotation angle, "
                      "Force and Torque are multiplied.",
                      Patterns::Anything());
    add_choice(prm,
               "Components",
               components,
               all_components(),
               "Of the Value of a displacement, traction or body force. "
               "cylindrical: radial; circumferential (; axial), about Rotation "
               "axis through Rotation centre, with the directions at the "
               "reference position.");
    prm.add_parameter("Active from",
                      active_from,
                      "The condition acts from this load time on; before, the "
                      "displacement is free, the load zero. Empty: always.",
                      Patterns::Anything());
    prm.add_parameter("Active until",
                      active_until,
                      "The condition acts up to this load time. Empty: to the "
                      "end.",
                      Patterns::Anything());
    prm.add_parameter("Locked from",
                      locked_from,
                      "Of a pretension: up to this load time Force acts, from "
                      "then on the length of the bolt stays as it is there. "
                      "Empty: Force acts to the end.",
                      Patterns::Anything());
  }



  void
  BoundaryConditionParameters::check(const std::string &path) const
  {
    const std::string &type_name =
      name_of(type, all_boundary_condition_types());
    const auto require = [&](const bool present, const std::string &name) {
      if (!present)
        throw UserError(path + "/" + name +
                        " is empty, but a condition of type '" + type_name +
                        "' needs it.");
    };
    const auto forbid = [&](const bool present, const std::string &name) {
      if (present)
        throw UserError(path + "/" + name +
                        " is given, but a condition of type '" + type_name +
                        "' has no use for it.");
    };

    require(!body.empty(), "Body");
    const bool has_value = (type == BoundaryConditionType::displacement ||
                            type == BoundaryConditionType::traction ||
                            type == BoundaryConditionType::pressure ||
                            type == BoundaryConditionType::follower_pressure ||
                            type == BoundaryConditionType::body_force);
    (has_value ? require(!value.empty(), "Value")
               : forbid(!value.empty(), "Value"));
    const bool moves = (type == BoundaryConditionType::displacement ||
                        type == BoundaryConditionType::rigid_motion);
    if (type == BoundaryConditionType::body_force)
      forbid(!boundary.empty(), "Boundary");
    else if (!moves)
      require(!boundary.empty(), "Boundary");
    if (!moves)
      forbid(!where.empty(), "Where");

    if (type != BoundaryConditionType::rigid_motion)
      {
        forbid(!translation.empty(), "Translation");
        forbid(!translation_stiffness.empty(), "Translation stiffness");
        forbid(!rotation_stiffness.empty(), "Rotation stiffness");
      }

    const bool has_torque = (type == BoundaryConditionType::rigid_motion ||
                             type == BoundaryConditionType::distributed_force);
    const bool has_force =
      (has_torque || type == BoundaryConditionType::pretension);
    if (!has_torque)
      forbid(!torque.empty(), "Torque");
    if (!has_force)
      forbid(!force.empty(), "Force");
    if (type == BoundaryConditionType::distributed_force && torque.empty())
      require(!force.empty(), "Force");
    if (!has_value && !has_force)
      forbid(!amplitude.empty(), "Amplitude");
    if (components == VectorComponents::cylindrical &&
        type != BoundaryConditionType::displacement &&
        type != BoundaryConditionType::traction &&
        type != BoundaryConditionType::body_force)
      throw UserError(path +
                      "/Components = cylindrical: a condition of type '" +
                      type_name + "' has no components.");
    active_interval(path);
    const bool repeats = (type == BoundaryConditionType::periodic ||
                          type == BoundaryConditionType::cyclic_symmetry);
    const bool joins   = repeats || type == BoundaryConditionType::pretension;
    if (joins)
      {
        forbid(!active_from.empty(), "Active from");
        forbid(!active_until.empty(), "Active until");
      }
    else
      forbid(!second_boundary.empty(), "Second boundary");
    if (type == BoundaryConditionType::pretension)
      {
        require(!second_boundary.empty(), "Second boundary");
        require(!force.empty(), "Force");
        forbid(!direction.empty(), "Direction");
        drawn_interval(path);
      }
    else
      {
        forbid(!second_body.empty(), "Second body");
        forbid(!locked_from.empty(), "Locked from");
      }

    if (type == BoundaryConditionType::spring && !(stiffness > 0.))
      throw UserError(path + "/Stiffness has to be greater than 0.");

    if (type == BoundaryConditionType::periodic)
      require(!direction.empty(), "Direction");
    if (type == BoundaryConditionType::cyclic_symmetry)
      forbid(!direction.empty(), "Direction");
    if (repeats)
      {
        if (boundary.size() != 1 || second_boundary.size() != 1)
          throw UserError(path +
                          ": 'Boundary' and 'Second boundary' of a "
                          "condition of type '" +
                          type_name + "' have to be one id or name each.");
      }
  }



  namespace
  {
    /// Leaves @p time as it is if @p text is empty.
    void
    read_time(const std::string &text, const std::string &path, double &time)
    {
      if (text.empty())
        return;
      try
        {
          time = Utilities::string_to_double(text);
        }
      catch (const ExceptionBase &)
        {
          throw UserError(path + " is '" + text +
                          "', but has to be a number or empty.");
        }
    }
  } // namespace



  ActiveInterval
  BoundaryConditionParameters::active_interval(const std::string &path) const
  {
    ActiveInterval interval;
    read_time(active_from, path + "/Active from", interval.from);
    read_time(active_until, path + "/Active until", interval.until);
    if (!(interval.from <= interval.until))
      throw UserError(path + "/Active until is " + active_until +
                      ", but 'Active from' is " + active_from +
                      ": the condition would never act.");
    return interval;
  }



  ActiveInterval
  BoundaryConditionParameters::drawn_interval(const std::string &path) const
  {
    ActiveInterval interval;
    read_time(locked_from, path + "/Locked from", interval.until);
    if (!(interval.until > 0.))
      throw UserError(
        path + "/Locked from is " + locked_from +
        ", but has to be greater than 0, to be tightened at all.");
    return interval;
  }



  std::vector<double>
  ends_of_intervals(const NamedList<BoundaryConditionParameters> &conditions)
  {
    const ActiveInterval always;
    std::vector<double>  times;
    for (const auto &[name, condition] : conditions)
      {
        const std::string path = "Boundary conditions/" + name;
        for (const ActiveInterval &interval :
             {condition.active_interval(path), condition.drawn_interval(path)})
          {
            if (interval.from != always.from)
              times.push_back(interval.from);
            if (interval.until != always.until)
              times.push_back(interval.until);
          }
      }
    return times;
  }



  template <int dim>
  Tensor<1, dim>
  BoundaryConditionParameters::unit_direction(const std::string &path) const
  {
    const Tensor<1, dim> vector =
      vector_from_parameter<dim>(direction, path + "/Direction");
    if (vector.norm() == 0.)
      throw UserError(path + "/Direction has no length.");
    return vector / vector.norm();
  }



  template Tensor<1, 2>
  BoundaryConditionParameters::unit_direction<2>(const std::string &) const;
  template Tensor<1, 3>
  BoundaryConditionParameters::unit_direction<3>(const std::string &) const;
} // namespace stickslip
