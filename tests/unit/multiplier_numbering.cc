// The numbers of the multipliers: contiguous on each rank, one owner per node,
// known to all ranks that use the node.

#include "print.h"

#include <stickslip/contact/surface/multiplier_numbering.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  /// 24 displacement dofs in blocks; each rank sees three more on both sides.
  void
  test(const std::vector<unsigned int> &n_components)
  {
    const unsigned int n_dofs = 24;
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const unsigned int first = rank * n_dofs / n_ranks;
    const unsigned int last  = (rank + 1) * n_dofs / n_ranks;
    IndexSet           owned(n_dofs), relevant(n_dofs);
    owned.add_range(first, last);
    relevant.add_range(std::max(first, 3u) - 3, std::min(last + 3, n_dofs));

    // Pair 0 has nodes at 0, 3, ..., 21, pair 1 at 12, ..., 18 and pair 2 none.
    // A rank names the nodes that it sees to its right, twice: the owner of a
    // node need not have a slave face there.
    std::vector<std::vector<types::global_dof_index>> keys(n_components.size());
    for (unsigned int repetition = 0; repetition < 2; ++repetition)
      for (const auto i : relevant)
        if (i % 3 == 0 && (i >= first + 3 || rank == 0))
          {
            keys[0].push_back(i);
            if (i >= 12 && i <= 18)
              keys[1].push_back(i);
          }
    const MultiplierNumbering numbering(
      owned, relevant, keys, n_components, MPI_COMM_WORLD);
    print("number of multipliers: " + std::to_string(numbering.n_dofs()));

    const auto counts =
      Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                 numbering.locally_owned().n_elements());
    print("every number has one owner",
          std::accumulate(counts.begin(), counts.end(), 0u) ==
              numbering.n_dofs() &&
            numbering.locally_owned().is_contiguous());

    bool         is_right = true;
    unsigned int n_nodes  = numbering.owned_nodes().size();
    for (const MultiplierNode &node : numbering.owned_nodes())
      {
        is_right = is_right && owned.is_element(node.key) &&
                   numbering.has_node(node.pair, node.key) &&
                   numbering.first_dof(node.pair, node.key) == node.first_dof;
        for (unsigned int c = 0; c < n_components[node.pair]; ++c)
          is_right = is_right &&
                     numbering.locally_owned().is_element(node.first_dof + c);
      }
    print("nodes belong to the owner of their displacements", is_right);
    print("number of nodes: " +
          std::to_string(Utilities::MPI::sum(n_nodes, MPI_COMM_WORLD)));

    // all that any rank knows of a node is the same, and nothing overlaps
    std::map<std::pair<unsigned int, types::global_dof_index>,
             types::global_dof_index>
      mine, all;
    for (const MultiplierNode &node : numbering.relevant_nodes())
      {
        mine[{node.pair, node.key}] = node.first_dof;
        for (unsigned int c = 0; c < n_components[node.pair]; ++c)
          is_right = is_right && numbering.locally_relevant().is_element(
                                   node.first_dof + c);
      }
    bool agrees = true;
    for (const auto &of_rank : Utilities::MPI::all_gather(MPI_COMM_WORLD, mine))
      for (const auto &[node, dof] : of_rank)
        agrees = agrees && all.emplace(node, dof).first->second == dof;
    std::vector<bool> is_used(numbering.n_dofs(), false);
    for (const auto &[node, dof] : all)
      for (unsigned int c = 0; c < n_components[node.first]; ++c)
        {
          agrees           = agrees && !is_used[dof + c];
          is_used[dof + c] = true;
        }
    print("all ranks agree", agrees);
    for (unsigned int p = 0; p < keys.size(); ++p)
      for (const auto key : keys[p])
        is_right = is_right && numbering.has_node(p, key) &&
                   numbering.first_dof(p, key) == all.at({p, key});
    print("every rank knows the nodes that it named", is_right);
    print("no other nodes",
          !numbering.has_node(0, 1) && !numbering.has_node(1, 3) &&
            !numbering.has_node(2, 3));
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  print("one component, two, three");
  test({1, 2, 3});
  print("all the same");
  test({3, 3, 3});
}
