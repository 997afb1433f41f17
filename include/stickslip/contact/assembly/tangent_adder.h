#ifndef stickslip_contact_assembly_tangent_adder_h
#define stickslip_contact_assembly_tangent_adder_h

#include <stickslip/base/rank_ranges.h>
#include <stickslip/base/types.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <map>
#include <vector>

namespace stickslip
{
  /**
   * Adds the tangents of contact points to the system of displacements (block
   * 0) and multipliers (block 1). Each has many zeros: a point at a node does
   * not know the other nodes of its face, and an open one hardly any. What is
   * left goes straight into the rows of the blocks. Rows of other ranks, mostly
   * those of the master, are sent to these at the end, which have time: few
   * ranks have contact points. Constraints are left to deal.II.
   */
  class TangentAdder
  {
  public:
    /// The owners of displacements and of multipliers.
    using Owners = std::array<RankRanges, 2>;

    /// All must outlive this object; the matrix must keep its sparsity.
    TangentAdder(const Constraints     &constraints,
                 const Owners          &owners,
                 LA::BlockSparseMatrix &matrix,
                 LA::BlockVector       &rhs);

    /// @p tangent (square) and @p forces have a row for each of @p dofs: first
    /// displacements, then multipliers, which count behind all displacements.
    void
    add(const FullMatrix<double>                   &tangent,
        const Vector<double>                       &forces,
        const std::vector<types::global_dof_index> &dofs);

    /// Exchanges the rows of other ranks. The matrix and the right hand side
    /// still have to be compressed. Collective.
    void
    finish();

  private:
    using Index = types::global_dof_index;

    /// Some rows and columns of a tangent.
    struct Part
    {
      std::vector<Index>  rows, columns;
      std::vector<double> entries; ///< row after row

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &rows &columns &entries;
      }
    };

    bool
    is_free(const std::vector<Index> &dofs) const;

    bool
    is_multiplier(const Index dof) const
    {
      return dof >= n_displacements;
    }

    unsigned int
    owner(const Index dof) const;

    /// The rows and columns of @p tangent that are not zero, by the owner of
    /// the rows.
    std::map<unsigned int, Part>
    split(const FullMatrix<double> &tangent, const std::vector<Index> &dofs);

    /// Adds rows that this rank owns.
    void
    add(const Part &part);

    const Constraints                         &constraints;
    const Owners                              &owners;
    LA::BlockSparseMatrix                     &matrix;
    LA::BlockVector                           &rhs;
    const Index                                n_displacements;
    const unsigned int                         my_rank;
    std::array<std::array<LA::RowAdder, 2>, 2> blocks;
    std::vector<bool>                          has_row, has_column;
    std::map<unsigned int, std::vector<Part>>  messages; ///< by rank
  };
} // namespace stickslip

#endif
