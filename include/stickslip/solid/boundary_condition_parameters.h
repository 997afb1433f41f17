#ifndef stickslip_solid_boundary_condition_parameters_h
#define stickslip_solid_boundary_condition_parameters_h

#include <stickslip/base/choice.h>

#include <deal.II/base/parameter_handler.h>
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
    periodic
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
    std::vector<std::string> second_boundary;

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

    /// "Direction" of a periodic condition as the number of a coordinate axis.
    template <int dim>
    unsigned int
    periodic_axis(const std::string &path) const;
  };

  /**
   * A vector from a parameter: a letter x, y, z for a unit vector, or @p dim
   * numbers separated by commas. Throws UserError naming @p path.
   */
  template <int dim>
  dealii::Tensor<1, dim>
  vector_from_parameter(const std::string &text, const std::string &path);
} // namespace stickslip

#endif
