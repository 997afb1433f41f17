#include <stickslip/problem/problem_sparsity.h>

#include <stickslip/base/over_ranks.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// @p displacements and those that @p constraints relate them to: nodes
    /// that hanging nodes of distant master faces hang on.
    IndexSet
    with_what_they_hang_on(IndexSet           displacements,
                           const Constraints &constraints)
    {
      std::vector<types::global_dof_index> others;
      for (const auto &line : constraints.get_lines())
        if (line.index < displacements.size())
          for (const auto &[other, weight] : line.entries)
            others.push_back(other);
      std::sort(others.begin(), others.end());
      displacements.add_indices(others.begin(), others.end());
      displacements.compress();
      return displacements;
    }
  } // namespace



  template <int dim>
  ProblemSparsity<dim>::ProblemSparsity(const DofLayout<dim>        &dofs,
                                        const ContactAssembler<dim> &contact,
                                        const MPI_Comm &communicator)
    : dofs(dofs)
    , contact(contact)
    , communicator(communicator)
    , couplings(contact)
  {}



  template <int dim>
  bool
  ProblemSparsity<dim>::update(const Constraints     &constraints,
                               LA::BlockSparseMatrix &matrix)
  {
    if (all_ranks(couplings.add_present(), communicator) && !is_outdated)
      return false;
    couplings.begin_pattern();
    is_outdated = false;
    matrix.clear(); // not two of them at a time
    const auto                 &multipliers = contact.multipliers();
    const std::vector<IndexSet> owned       = {dofs.owned,
                                               multipliers.locally_owned()};
    const std::vector<IndexSet> writable    = {
         with_what_they_hang_on(contact.needed_displacements(), constraints),
         multipliers.locally_relevant()};
    // Trilinos' own patterns take twice as long to fill.
    BlockDynamicSparsityPattern          pattern(writable);
    std::vector<types::global_dof_index> cell_dofs;
    for (const auto &cell : dofs.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell_dofs.resize(cell->get_fe().n_dofs_per_cell());
          cell->get_dof_indices(cell_dofs);
          constraints.add_entries_local_to_global(cell_dofs, pattern, false);
        }
    const types::global_dof_index n_u   = dofs.owned.size();
    const auto                   &pairs = contact.contact_pairs();
    for (const auto &coupled : couplings.coupled_dofs(n_u))
      constraints.add_entries_local_to_global(coupled, pattern, false);
    // open and unpaired points have rows of their own
    for (const auto &pair : pairs)
      {
        const unsigned int n_places =
          pair->mortar ? pair->points.size() : pair->slave_faces.size();
        for (unsigned int place = 0; place < n_places; ++place)
          constraints.add_entries_local_to_global(dofs_at(*pair, place, n_u),
                                                  pattern,
                                                  false);
      }
    for (const auto i : multipliers.locally_owned())
      pattern.block(1, 1).add(i, i);
    for (unsigned int b = 0; b < owned.size(); ++b)
      for (unsigned int c = 0; c < owned.size() && owned[b].size() > 0; ++c)
        SparsityTools::distribute_sparsity_pattern(pattern.block(b, c),
                                                   owned[b],
                                                   communicator,
                                                   writable[b]);
    matrix.reinit(owned, pattern, communicator);
    return true;
  }

  template class ProblemSparsity<2>;
  template class ProblemSparsity<3>;
} // namespace stickslip
