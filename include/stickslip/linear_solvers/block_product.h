#ifndef stickslip_linear_solvers_block_product_h
#define stickslip_linear_solvers_block_product_h

#include <stickslip/base/types.h>

#include <stickslip/linear_solvers/neighbour_product.h>

#include <array>
#include <vector>

namespace stickslip
{
  /// The entries of a vector [displacements, multipliers] that a rank owns, one
  /// block after the other.
  using OwnedEntries = std::vector<double>;

  OwnedEntries
  owned_entries(const LA::BlockVector &vector);

  void
  set_owned_entries(LA::BlockVector &vector, const OwnedEntries &entries);



  /// Products with the block matrix [A C; B -E], of which a rank waits for its
  /// neighbours once.
  class BlockProduct
  {
  public:
    /// @p matrix must outlive this object and keep its sparsity. Without
    /// communication.
    void
    reinit(const LA::BlockSparseMatrix &matrix);

    unsigned int
    n_displacements() const
    {
      return n_rows[0];
    }

    unsigned int
    n_multipliers() const
    {
      return n_rows[1];
    }

    /// y = matrix x. Collective.
    void
    vmult(OwnedEntries &y, const OwnedEntries &x) const;

    /// y = matrix x for multipliers that are zero. Collective.
    void
    vmult_displacements(OwnedEntries &y, const OwnedEntries &x) const;

  private:
    std::array<unsigned int, 2>                    n_rows{{0, 0}};
    std::array<std::array<NeighbourProduct, 2>, 2> blocks;

    void
    vmult(OwnedEntries       &y,
          const OwnedEntries &x,
          const unsigned int  n_columns) const;
  };
} // namespace stickslip

#endif
