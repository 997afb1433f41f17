#ifndef stickslip_problem_linear_space_h
#define stickslip_problem_linear_space_h

#include <stickslip/problem/dof_layout.h>

#include <memory>

namespace stickslip
{
  /**
   * Linear elements on the mesh of displacements of a higher degree: the coarse
   * space of p-multigrid.
   */
  template <int dim>
  class LinearSpace
  {
  public:
    /// Collective. @p fine must outlive this object.
    LinearSpace(const DofLayout<dim> &fine, const MPI_Comm &communicator);

    /**
     * Constrains vertices as @p fine_constraints (of an increment) do, and
     * hanging ones to their linear neighbours, and makes the prolongation.
     * Collective.
     */
    void
    update(const Constraints &fine_constraints);

    const DoFHandler<dim> &
    handler() const
    {
      return dof_handler;
    }

    const Constraints &
    constraints() const
    {
      return lines;
    }

    /**
     * Values at the nodes of the displacement space of functions that satisfy
     * the constraints. The row of a constrained dof is empty, or at a vertex
     * the identity, so that P^T A P has a diagonal there.
     */
    std::shared_ptr<const LA::SparseMatrix>
    prolongation() const
    {
      return matrix;
    }

  private:
    const DofLayout<dim>             &fine;
    const hp::FECollection<dim>       elements;
    DoFHandler<dim>                   dof_handler;
    IndexSet                          owned;
    MPI_Comm                          communicator;
    Constraints                       lines;
    std::shared_ptr<LA::SparseMatrix> matrix;

    void
    constrain(const Constraints &fine_constraints);

    /// Calls visit(fine dof, linear dofs, values) for each owned dof once.
    template <typename Visitor>
    void
    visit_rows(const Constraints &fine_constraints, const Visitor &visit) const;
  };
} // namespace stickslip

#endif
