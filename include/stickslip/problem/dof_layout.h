#ifndef stickslip_problem_dof_layout_h
#define stickslip_problem_dof_layout_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/periodic_nodes.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/index_set.h>

#include <deal.II/distributed/tria_base.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/fe_collection.h>
#include <deal.II/hp/mapping_collection.h>

#include <vector>

namespace stickslip
{
  /**
   * The displacement space: FE_Q(degree)^dim and FE_SimplexP(degree)^dim, each
   * on the cells of its kind, on isoparametric mappings
   * (mesh/conforming_mapping.h). Its support points are the nodes of the
   * geometry, which the contact faces rely on.
   */
  template <int dim>
  class DofLayout
  {
  public:
    /// Collective.
    DofLayout(const parallel::DistributedTriangulationBase<dim> &triangulation,
              const unsigned int                                 degree,
              const std::vector<PeriodicBoundary>               &periodic);

    unsigned int
    degree() const
    {
      return elements[0].degree;
    }

    /// The cells and the element of a model with one kind of cells: what can be
    /// refined while it is computed has no other.
    const ReferenceCell &
    cells() const
    {
      AssertDimension(kinds.size(), 1);
      return kinds[0];
    }

    const FiniteElement<dim> &
    fe() const
    {
      AssertDimension(kinds.size(), 1);
      return elements[0];
    }

    const std::vector<ReferenceCell> kinds; ///< of the cells of all bodies
    const hp::MappingCollection<dim> mapping;
    const hp::FECollection<dim>      elements;
    DoFHandler<dim>                  dof_handler;
    IndexSet                         owned;
    IndexSet                         relevant;
    PeriodicNodes<dim>               periodic_nodes;
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
