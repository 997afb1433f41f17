#include <stickslip/problem/problem_sparsity.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <vector>

namespace stickslip
{
  template <int dim>
  ProblemSparsity<dim>::ProblemSparsity(const DofLayout<dim>        &dofs,
                                        const ContactAssembler<dim> &contact,
                                        const MPI_Comm &communicator)
    : dofs(dofs)
    , contact(contact)
    , communicator(communicator)
  {}



  template <int dim>
  void
  ProblemSparsity<dim>::forget_couplings()
  {
    known_couplings.clear();
    is_outdated = true;
  }



  template <int dim>
  bool
  ProblemSparsity<dim>::couplings_are_known()
  {
    unsigned int n_new = 0;
    const auto  &pairs = contact.contact_pairs();
    for (unsigned int p = 0; p < pairs.size(); ++p)
      for (const auto &point : pairs[p]->points)
        if (point.pairing.paired)
          n_new += known_couplings
                     .emplace(p,
                              point.geometry.slave_face,
                              pairs[p]->patch->face(point.pairing.face).id)
                     .second;
    return Utilities::MPI::sum(n_new, communicator) == 0;
  }



  template <int dim>
  bool
  ProblemSparsity<dim>::update(const Constraints     &constraints,
                               LA::BlockSparseMatrix &matrix)
  {
    // Couplings are only ever added while the patches stay the same, so a node
    // that hops between facets costs one rebuild, not one per hop.
    if (couplings_are_known() && !is_outdated)
      return false;
    is_outdated = false;
    matrix.clear(); // not two of them at a time
    const auto                 &multipliers = contact.multipliers();
    const std::vector<IndexSet> owned       = {dofs.owned,
                                               multipliers.locally_owned()};
    const std::vector<IndexSet> writable    = {contact.needed_displacements(),
                                               multipliers.locally_relevant()};
    TrilinosWrappers::BlockSparsityPattern pattern(owned,
                                                   owned,
                                                   writable,
                                                   communicator);
    std::vector<types::global_dof_index>   cell_dofs(dofs.fe.n_dofs_per_cell());
    for (const auto &cell : dofs.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(cell_dofs);
          constraints.add_entries_local_to_global(cell_dofs, pattern, false);
        }
    const types::global_dof_index        n_u   = dofs.owned.size();
    const auto                          &pairs = contact.contact_pairs();
    std::vector<types::global_dof_index> coupled;
    for (const auto &[p, f, id] : known_couplings)
      {
        const auto &slave = pairs[p]->slave_faces[f];
        coupled           = slave.face.dofs;
        const auto &master =
          pairs[p]->patch->face(pairs[p]->patch->index_of(id)).dofs;
        coupled.insert(coupled.end(), master.begin(), master.end());
        for (const auto dof : slave.multiplier_dofs)
          coupled.push_back(n_u + dof);
        constraints.add_entries_local_to_global(coupled, pattern, false);
      }
    // open and unpaired points have rows of their own
    for (const auto &pair : pairs)
      for (const auto &slave : pair->slave_faces)
        {
          coupled = slave.face.dofs;
          for (const auto dof : slave.multiplier_dofs)
            coupled.push_back(n_u + dof);
          constraints.add_entries_local_to_global(coupled, pattern, false);
        }
    for (const auto i : multipliers.locally_owned())
      pattern.block(1, 1).add(i, i);
    pattern.compress();
    matrix.reinit(pattern);
    return true;
  }

  template class ProblemSparsity<2>;
  template class ProblemSparsity<3>;
} // namespace stickslip
