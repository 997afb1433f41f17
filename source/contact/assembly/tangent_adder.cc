#include <stickslip/contact/assembly/tangent_adder.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <utility>

namespace stickslip
{
  TangentAdder::TangentAdder(const Constraints     &constraints,
                             const Owners          &owners,
                             LA::BlockSparseMatrix &matrix,
                             LA::BlockVector       &rhs)
    : constraints(constraints)
    , owners(owners)
    , matrix(matrix)
    , rhs(rhs)
    , n_displacements(owners[0].n_global())
    , my_rank(Utilities::MPI::this_mpi_process(matrix.get_mpi_communicator()))
    , blocks{
        {{{LA::RowAdder(matrix.block(0, 0)), LA::RowAdder(matrix.block(0, 1))}},
         {{LA::RowAdder(matrix.block(1, 0)),
           LA::RowAdder(matrix.block(1, 1))}}}}
  {}



  bool
  TangentAdder::is_free(const std::vector<Index> &dofs) const
  {
    return std::none_of(dofs.begin(), dofs.end(), [this](const auto dof) {
      return constraints.is_constrained(dof);
    });
  }



  unsigned int
  TangentAdder::owner(const Index dof) const
  {
    return is_multiplier(dof) ? owners[1].rank_of(dof - n_displacements)
                              : owners[0].rank_of(dof);
  }



  std::map<unsigned int, TangentAdder::Part>
  TangentAdder::split(const FullMatrix<double> &tangent,
                      const std::vector<Index> &dofs)
  {
    const unsigned int n = dofs.size();
    has_row.assign(n, false);
    has_column.assign(n, false);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (tangent(i, j) != 0.)
          has_row[i] = has_column[j] = true;

    std::map<unsigned int, Part> parts;
    for (unsigned int i = 0; i < n; ++i)
      if (has_row[i])
        {
          Part &part = parts[owner(dofs[i])];
          part.rows.push_back(dofs[i]);
          for (unsigned int j = 0; j < n; ++j)
            if (has_column[j])
              part.entries.push_back(tangent(i, j));
        }
    for (auto &[rank, part] : parts)
      for (unsigned int j = 0; j < n; ++j)
        if (has_column[j])
          part.columns.push_back(dofs[j]);
    return parts;
  }



  void
  TangentAdder::add(const Part &part)
  {
    std::array<std::vector<Index>, 2> columns;
    for (const Index column : part.columns)
      if (is_multiplier(column))
        columns[1].push_back(column - n_displacements);
      else
        columns[0].push_back(column);
    for (auto &block_row : blocks)
      for (unsigned int b = 0; b < 2; ++b)
        block_row[b].set_columns(columns[b]);

    const double *entry = part.entries.data();
    for (const Index dof : part.rows)
      {
        const Index row = is_multiplier(dof) ? dof - n_displacements : dof;
        for (unsigned int b = 0; b < 2; ++b)
          {
            blocks[is_multiplier(dof)][b].add(row,
                                              {entry, columns[b].size()},
                                              1.);
            entry += columns[b].size();
          }
      }
  }



  void
  TangentAdder::add(const FullMatrix<double> &tangent,
                    const Vector<double>     &forces,
                    const std::vector<Index> &dofs)
  {
    if (!is_free(dofs))
      {
        constraints.distribute_local_to_global(
          tangent, forces, dofs, matrix, rhs);
        return;
      }
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (forces[i] != 0.)
        rhs(dofs[i]) += forces[i];
    auto parts = split(tangent, dofs);
    for (auto &[rank, part] : parts)
      if (rank == my_rank)
        add(part);
      else
        messages[rank].push_back(std::move(part));
  }



  void
  TangentAdder::finish()
  {
    for (const auto &[rank, parts] :
         Utilities::MPI::some_to_some(matrix.get_mpi_communicator(), messages))
      for (const Part &part : parts)
        add(part);
    messages.clear();
  }
} // namespace stickslip
