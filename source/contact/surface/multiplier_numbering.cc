#include <stickslip/contact/surface/multiplier_numbering.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>

namespace stickslip
{
  MultiplierNumbering::MultiplierNumbering(
    const IndexSet &owned_displacements,
    const IndexSet &relevant_displacements,
    const std::vector<std::vector<types::global_dof_index>> &keys,
    const std::vector<unsigned int>                         &n_components,
    const MPI_Comm                                          &communicator)
  {
    // Mark the nodes; the owner of the displacement learns of marks elsewhere.
    using Marks = LinearAlgebra::distributed::Vector<double>;
    std::vector<Marks>      marks(keys.size());
    types::global_dof_index n_owned = 0;
    for (unsigned int p = 0; p < keys.size(); ++p)
      {
        marks[p].reinit(owned_displacements,
                        relevant_displacements,
                        communicator);
        for (const auto key : keys[p])
          marks[p](key) = 1.;
        marks[p].compress(VectorOperation::max);
        for (unsigned int i = 0; i < marks[p].locally_owned_size(); ++i)
          n_owned += marks[p].local_element(i) > 0. ? n_components[p] : 0;
      }
    types::global_dof_index start = 0;
    const int               error = MPI_Exscan(
      &n_owned, &start, 1, DEAL_II_DOF_INDEX_MPI_TYPE, MPI_SUM, communicator);
    AssertThrowMPI(error);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      start = 0; // MPI leaves it undefined there
    const auto total = Utilities::MPI::sum(n_owned, communicator);
    owned.set_size(total);
    owned.add_range(start, start + n_owned);
    owned.compress();

    // Replace the marks by numbers + 1 and tell the other ranks.
    types::global_dof_index next = start;
    for (unsigned int p = 0; p < keys.size(); ++p)
      {
        for (unsigned int i = 0; i < marks[p].locally_owned_size(); ++i)
          if (marks[p].local_element(i) > 0.)
            {
              const auto key = owned_displacements.nth_index_in_set(i);
              nodes.push_back({p, key, next});
              marks[p].local_element(i) = 1. + next;
              next += n_components[p];
            }
        marks[p].update_ghost_values();
      }

    // All nodes in sight: those of owned slave faces, and those that a hanging
    // node of such a face is constrained to.
    relevant  = owned;
    all_nodes = nodes;
    first_dofs.resize(keys.size());
    for (const MultiplierNode &node : nodes)
      first_dofs[node.pair][node.key] = node.first_dof;
    for (unsigned int p = 0; p < keys.size(); ++p)
      for (const auto key : relevant_displacements)
        if (marks[p](key) > 0.)
          {
            const auto first =
              static_cast<types::global_dof_index>(marks[p](key) - 0.5);
            if (first_dofs[p].emplace(key, first).second)
              all_nodes.push_back({p, key, first});
            relevant.add_range(first, first + n_components[p]);
          }
    relevant.compress();
  }



  types::global_dof_index
  MultiplierNumbering::first_dof(const unsigned int            pair,
                                 const types::global_dof_index key) const
  {
    return first_dofs[pair].at(key);
  }



  bool
  MultiplierNumbering::has_node(const unsigned int            pair,
                                const types::global_dof_index key) const
  {
    return first_dofs[pair].count(key) > 0;
  }
} // namespace stickslip
