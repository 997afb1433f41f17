#ifndef stickslip_solid_axisymmetry_h
#define stickslip_solid_axisymmetry_h

#include <stickslip/mesh/body.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/prescribed_displacement.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Throws UserError if the condition at @p path is none of bodies of
   * revolution without torsion, whose only rigid motion is that along y.
   */
  void
  check_is_axisymmetric(const BoundaryConditionParameters &parameters,
                        const std::string                 &path);

  /**
   * What holds of itself where the radius is zero: no radial displacement of
   * deformable bodies of revolution. Empty in all other models.
   */
  template <int dim>
  std::vector<PrescribedDisplacement<dim>>
  conditions_on_axis(const Bodies &bodies);
} // namespace stickslip

#endif
