#ifndef stickslip_problem_problem_sparsity_h
#define stickslip_problem_problem_sparsity_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/problem/dof_layout.h>

#include <set>
#include <tuple>

namespace stickslip
{
  /**
   * Sparsity pattern of the tangent: cells, and the couplings of slave and
   * master faces that were paired since the master patches were fetched.
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

    /// Pair, slave face or mortar node, master face.
    std::set<std::tuple<unsigned int, unsigned int, FaceId>> known_couplings;
    bool                                                     is_outdated = true;
    bool is_first   = true;  ///< no pattern yet
    bool has_hopped = false; ///< points have met other facets than before

    /// Adds those of the points. Collective.
    bool
    couplings_are_known();

    /// Removes those with facets that are no longer in the patches.
    void
    drop_distant_couplings();

    /// Adds those with the neighbours of the facets that points have now.
    void
    add_couplings_nearby();
  };
} // namespace stickslip

#endif
