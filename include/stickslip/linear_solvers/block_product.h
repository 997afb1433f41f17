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
    /// @p matrix must outlive this object and keep its sparsity. The part of
    /// set_part() stays. Without communication.
    void
    reinit(const LA::BlockSparseMatrix &matrix);

    /// Unknowns for which add_part() is called: those where @p marks is not
    /// zero. To be called for each new sparsity. Collective.
    void
    set_part(const OwnedEntries &marks);

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

    /// y += matrix x for an @p x that is zero outside of the part: takes a
    /// product with the rows that see it. Collective.
    void
    add_part(OwnedEntries &y, const OwnedEntries &x) const;

  private:
    template <typename T>
    using OfBlocks = std::array<std::array<T, 2>, 2>;

    std::array<unsigned int, 2> n_rows{{0, 0}};
    OfBlocks<NeighbourProduct>  blocks;
    OfBlocks<std::vector<int>>  rows_of_part;

    void
    vmult(OwnedEntries       &y,
          const OwnedEntries &x,
          const unsigned int  n_columns) const;

    /// Starts the exchanges of the first @p n_columns columns of blocks, then
    /// calls finish(row, column, where x begins for this column).
    template <typename Finish>
    void
    for_each_block(const OwnedEntries &x,
                   const unsigned int  n_columns,
                   const Finish       &finish) const;
  };
} // namespace stickslip

#endif
