#include <stickslip/contact/assembly/tangent_adder.h>

#include <algorithm>

namespace stickslip
{
  TangentAdder::TangentAdder(const Constraints     &constraints,
                             LA::BlockSparseMatrix &matrix,
                             LA::BlockVector       &rhs)
    : constraints(constraints)
    , matrix(matrix)
    , rhs(rhs)
    , n_displacements(matrix.block(0, 0).m())
    , blocks{
        {{{LA::RowAdder(matrix.block(0, 0)), LA::RowAdder(matrix.block(0, 1))}},
         {{LA::RowAdder(matrix.block(1, 0)),
           LA::RowAdder(matrix.block(1, 1))}}}}
  {}



  bool
  TangentAdder::is_free(const std::vector<types::global_dof_index> &dofs) const
  {
    return std::none_of(dofs.begin(), dofs.end(), [this](const auto dof) {
      return constraints.is_constrained(dof);
    });
  }



  void
  TangentAdder::find_columns(const FullMatrix<double> &tangent,
                             const std::vector<types::global_dof_index> &dofs)
  {
    for (Columns &of_block : columns)
      {
        of_block.in_tangent.clear();
        of_block.in_block.clear();
      }
    for (unsigned int j = 0; j < dofs.size(); ++j)
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (tangent(i, j) != 0.)
          {
            const bool is_multiplier = (dofs[j] >= n_displacements);
            columns[is_multiplier].in_tangent.push_back(j);
            columns[is_multiplier].in_block.push_back(
              is_multiplier ? dofs[j] - n_displacements : dofs[j]);
            break;
          }
    for (auto &row_of_blocks : blocks)
      for (unsigned int b = 0; b < 2; ++b)
        row_of_blocks[b].set_columns(columns[b].in_block);
  }



  void
  TangentAdder::add_row(const FullMatrix<double>     &tangent,
                        const unsigned int            i,
                        const types::global_dof_index dof)
  {
    const bool is_multiplier = (dof >= n_displacements);
    for (unsigned int b = 0; b < 2; ++b)
      {
        bool is_zero = true;
        row.clear();
        for (const unsigned int j : columns[b].in_tangent)
          {
            row.push_back(tangent(i, j));
            is_zero = is_zero && row.back() == 0.;
          }
        if (!is_zero)
          blocks[is_multiplier][b].add(
            is_multiplier ? dof - n_displacements : dof, row, 1.);
      }
  }



  void
  TangentAdder::add(const FullMatrix<double>                   &tangent,
                    const Vector<double>                       &forces,
                    const std::vector<types::global_dof_index> &dofs)
  {
    if (!is_free(dofs))
      {
        constraints.distribute_local_to_global(
          tangent, forces, dofs, matrix, rhs);
        return;
      }
    find_columns(tangent, dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        add_row(tangent, i, dofs[i]);
        if (forces[i] != 0.)
          rhs(dofs[i]) += forces[i];
      }
  }
} // namespace stickslip
