#ifndef stickslip_contact_assembly_tangent_adder_h
#define stickslip_contact_assembly_tangent_adder_h

#include <stickslip/base/types.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * Adds the tangents of contact points to the system of displacements (block
   * 0) and multipliers (block 1). Each has many zeros: a point at a node does
   * not know the other nodes of its face, and an open one hardly any. Points
   * whose displacements are free go straight into the rows of the blocks; the
   * constraints of the others are resolved by deal.II.
   */
  class TangentAdder
  {
  public:
    /// All must outlive this object; the matrix must keep its sparsity.
    TangentAdder(const Constraints     &constraints,
                 LA::BlockSparseMatrix &matrix,
                 LA::BlockVector       &rhs);

    /// @p tangent (square) and @p forces have a row for each of @p dofs, which
    /// count multipliers behind all displacements. The matrix and the right
    /// hand side must be compressed at the end.
    void
    add(const FullMatrix<double>                   &tangent,
        const Vector<double>                       &forces,
        const std::vector<types::global_dof_index> &dofs);

  private:
    bool
    is_free(const std::vector<types::global_dof_index> &dofs) const;

    /// The columns of @p tangent, by block, that are not zero.
    void
    find_columns(const FullMatrix<double>                   &tangent,
                 const std::vector<types::global_dof_index> &dofs);

    void
    add_row(const FullMatrix<double>     &tangent,
            const unsigned int            i,
            const types::global_dof_index dof);

    struct Columns
    {
      std::vector<unsigned int>            in_tangent;
      std::vector<types::global_dof_index> in_block;
    };

    const Constraints                         &constraints;
    LA::BlockSparseMatrix                     &matrix;
    LA::BlockVector                           &rhs;
    const types::global_dof_index              n_displacements;
    std::array<std::array<LA::RowAdder, 2>, 2> blocks;
    std::array<Columns, 2>                     columns;
    std::vector<double>                        row;
  };
} // namespace stickslip

#endif
