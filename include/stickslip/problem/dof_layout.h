#ifndef stickslip_problem_dof_layout_h
#define stickslip_problem_dof_layout_h

#include <stickslip/base/types.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/index_set.h>

#include <deal.II/distributed/tria_base.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <memory>

namespace stickslip
{
  /**
   * The displacement space: FE_Q(degree)^dim on an isoparametric mapping
   * (mesh/conforming_mapping.h), or FE_SimplexP(degree)^dim on straight cells.
   * Its support points are the nodes of the geometry, which the contact faces
   * rely on.
   */
  template <int dim>
  class DofLayout
  {
  public:
    DofLayout(const parallel::DistributedTriangulationBase<dim> &triangulation,
              const unsigned int                                 degree);

    const ReferenceCell cells; ///< of all bodies

  private:
    const std::unique_ptr<const Mapping<dim>> owned_mapping;

  public:
    const Mapping<dim> &mapping;
    const FESystem<dim> fe;
    DoFHandler<dim>     dof_handler;
    IndexSet            owned;
    IndexSet            relevant;
  };

  /// [displacements, multipliers] as one index set, multipliers shifted.
  IndexSet
  combined_index_set(const IndexSet &displacements,
                     const IndexSet &multipliers);

  /// Copies the lines of @p from (displacements only) to @p to.
  void
  copy_lines(const Constraints &from, Constraints &to);
} // namespace stickslip

#endif
