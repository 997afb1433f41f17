#ifndef stickslip_linear_solvers_interface_augmentation_h
#define stickslip_linear_solvers_interface_augmentation_h

#include <stickslip/base/block_system.h>

#include <stickslip/linear_solvers/block_product.h>
#include <stickslip/linear_solvers/multigrid/block_rows.h>

#include <vector>

namespace stickslip
{
  /**
   * The augmented Lagrangian form of a block system [A C; B -E]: its first rows
   * plus B^T D^-1 times its second rows. The solution stays the same, and
   * A + B^T D^-1 B is a matrix that multigrid can handle: bodies are held where
   * they touch. D is diagonal, so that the term couples what a multiplier
   * couples. B^T and not C: the term is symmetric whatever friction does.
   */
  class InterfaceAugmentation
  {
  public:
    /**
     * Takes D from @p description (divided by @p factor) plus the diagonal of
     * E: rows of open contact stay without effect, and sliding ones count as
     * much as they hold. Rows that are not positive then are left out. The
     * matrix must outlive this object. Collective.
     */
    void
    reinit(const LA::BlockSparseMatrix  &matrix,
           const BlockSystemDescription &description,
           const double                  factor);

    /// B^T D^-1 B for the owned displacements, in blocks of nodes of @p n of
    /// them. Rows away from the surfaces are empty. Collective.
    BlockRows<double>
    added_blocks(const unsigned int n) const;

    /// Adds B^T D^-1 times the multipliers of @p entries to their displacements.
    /// Collective.
    void
    add_to(OwnedEntries &entries) const;

    /// What each multiplier adds to the stiffness: the squares of its row of B
    /// over D. Collective.
    LA::Vector
    added_stiffness() const;

    /// D^-1 by multiplier.
    const LA::Vector &
    inverse_diagonal() const
    {
      return inverse;
    }

  private:
    const LA::BlockSparseMatrix *matrix = nullptr;
    LA::Vector                   inverse;
    NeighbourProduct             product; ///< with B
    mutable std::vector<double>  scaled;
  };
} // namespace stickslip

#endif
