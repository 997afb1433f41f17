#ifndef stickslip_solid_boundary_condition_parameters_h
#define stickslip_solid_boundary_condition_parameters_h

#include <stickslip/base/choice.h>
#include <stickslip/base/parameter_file.h>

#include <stickslip/solid/active_interval.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace stickslip
{
  enum class BoundaryConditionType
  {
    displacement,
    symmetry,
    rigid_motion,
    traction,
    pressure,
    follower_pressure,
    spring,
    body_force,
    distributed_force,
    periodic,
    cyclic_symmetry,
    pretension
  };

  enum class VectorComponents
  {
    cartesian,
    cylindrical
  };

  const Choices<BoundaryConditionType> &
  all_boundary_condition_types();

  /**
   * One member of the section "Boundary conditions". Expressions are muparser
   * functions of the reference position x, y (, z) and of the load time t,
   * with the constant pi.
   */
  struct BoundaryConditionParameters
  {
    std::string              body;
    std::vector<std::string> boundary; ///< ids or names; may be empty
    BoundaryConditionType    type = BoundaryConditionType::displacement;
    std::string              value;
    std::string              where;
    std::string              direction;
    double                   stiffness = 0.;
    std::string              translation;
    std::string              rotation_angle  = "0";
    std::string              rotation_axis   = "z";
    std::string              rotation_centre = "";
    std::string              force, torque;
    std::string              translation_stiffness, rotation_stiffness;
    std::string              second_body; ///< empty: the same
    std::vector<std::string> second_boundary;
    std::string              amplitude;
    VectorComponents         components = VectorComponents::cartesian;
    std::string              active_from, active_until;
    std::string              locked_from;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * Throws UserError if what the type needs is missing or malformed
     * (expressions excepted: BoundaryConditions parses those). @p path is the
     * section of this condition, "Boundary conditions/<name>".
     */
    void
    check(const std::string &path) const;

    /**
     * "Direction" as a unit vector: a letter x, y, z or @p dim numbers. Throws
     * UserError if it has another form or no length.
     */
    template <int dim>
    dealii::Tensor<1, dim>
    unit_direction(const std::string &path) const;

    /// Throws UserError if an end is no number or the interval is empty.
    ActiveInterval
    active_interval(const std::string &path) const;

    /// When the force of a pretension acts. Throws UserError if the end is no
    /// number.
    ActiveInterval
    drawn_interval(const std::string &path) const;
  };

  /// The load times at which one of the conditions begins or ceases to act, or
  /// is locked.
  std::vector<double>
  ends_of_intervals(const NamedList<BoundaryConditionParameters> &conditions);
} // namespace stickslip

#endif
