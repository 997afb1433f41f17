#ifndef stickslip_solid_periodic_conditions_h
#define stickslip_solid_periodic_conditions_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/mesh/periodicity.h>

#include <stickslip/solid/boundary_condition_parameters.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// "Direction" of a periodic condition as the number of a coordinate axis.
  /// @p path is the section of the condition.
  template <int dim>
  unsigned int
  periodic_axis(const BoundaryConditionParameters &condition,
                const std::string                 &path);

  /// What conditions of the types periodic and cyclic symmetry want of the mesh
  /// of a model in @p dimension. Throws UserError for directions and axes that
  /// make no sense.
  std::vector<PeriodicRequest>
  periodic_requests(const NamedList<BoundaryConditionParameters> &conditions,
                    const unsigned int                            dimension);
} // namespace stickslip

#endif
