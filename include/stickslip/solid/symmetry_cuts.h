#ifndef stickslip_solid_symmetry_cuts_h
#define stickslip_solid_symmetry_cuts_h

#include <stickslip/solid/prescribed_displacement.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <set>
#include <vector>

namespace stickslip
{
  /**
   * Unit normals of the planes of symmetry that cut @p boundary, so that it is
   * only the part of a surface that is in the model: those of the lasting
   * conditions of type symmetry whose faces share edges (2D: vertices) with it.
   * Each direction once. Collective.
   */
  template <int dim>
  std::vector<Tensor<1, dim>>
  normals_of_symmetry_cuts(
    const hp::MappingCollection<dim>               &mapping,
    const DoFHandler<dim>                          &dof_handler,
    const std::set<types::boundary_id>             &boundary,
    const std::vector<PrescribedDisplacement<dim>> &conditions);
} // namespace stickslip

#endif
