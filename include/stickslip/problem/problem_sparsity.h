#ifndef stickslip_problem_problem_sparsity_h
#define stickslip_problem_problem_sparsity_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/problem/contact_couplings.h>
#include <stickslip/problem/dof_layout.h>

namespace stickslip
{
  /**
   * Sparsity pattern of the tangent: cells, and what contact couples.
   */
  template <int dim>
  class ProblemSparsity
  {
  public:
    /// @p dofs and @p contact must outlive this object.
    ProblemSparsity(const DofLayout<dim>        &dofs,
                    const ContactAssembler<dim> &contact,
                    const MPI_Comm              &communicator);

    /// Other degrees of freedom are constrained: the pattern is built anew.
    void
    invalidate()
    {
      is_outdated = true;
    }

    /// Gives @p matrix a new pattern (and true) if the present pairings need
    /// one. Collective.
    bool
    update(const Constraints &constraints, LA::BlockSparseMatrix &matrix);

  private:
    const DofLayout<dim>        &dofs;
    const ContactAssembler<dim> &contact;
    const MPI_Comm               communicator;

    ContactCouplings<dim> couplings;
    bool                  is_outdated = true;
  };
} // namespace stickslip

#endif
