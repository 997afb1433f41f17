#ifndef stickslip_linear_solvers_multigrid_node_space_h
#define stickslip_linear_solvers_multigrid_node_space_h

#include <deal.II/base/partitioner.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * The unknowns of a multigrid level, in groups: those of a node of the mesh,
   * or the columns of an aggregate. Nodes are numbered over all ranks, a range
   * of them on each. The local numbers are first those of the owned nodes, then
   * those of the ghosts, in ascending order; vectors hold the unknowns in the
   * same order.
   */
  class NodeSpace
  {
  public:
    using Index = types::global_dof_index;

    NodeSpace() = default;

    /// @p sizes: unknowns of each owned node. No ghosts yet. Collective.
    NodeSpace(const std::vector<unsigned int> &sizes,
              const MPI_Comm                  &communicator);

    /// Nodes of @p n consecutive unknowns, of which this rank owns
    /// @p unknowns. Collective.
    NodeSpace(const IndexSet    &unknowns,
              const unsigned int n,
              const MPI_Comm    &communicator);

    /// Sets the nodes of other ranks that this one has to see (any order, with
    /// repetitions). Collective.
    void
    set_ghosts(std::vector<Index> nodes);

    unsigned int
    n_owned() const
    {
      return n_owned_nodes;
    }

    /// Nodes of all ranks; none if it is only declared.
    Index
    n_global() const
    {
      return rank_begins.empty() ? 0 : rank_begins.back();
    }

    /// Owned nodes and ghosts.
    unsigned int
    n_local() const
    {
      return n_owned_nodes + ghosts.size();
    }

    bool
    owns(const Index node) const
    {
      return node >= first && node < first + n_owned_nodes;
    }

    /// Whether a node is owned or a ghost.
    bool
    sees(const Index node) const
    {
      return owns(node) ||
             std::binary_search(ghosts.begin(), ghosts.end(), node);
    }

    unsigned int
    local(const Index node) const;

    Index
    global(const unsigned int node) const
    {
      return node < n_owned_nodes ? first + node : ghosts[node - n_owned_nodes];
    }

    /// First unknown of a local node in a vector; begin(n_local()) is the
    /// length of vectors.
    unsigned int
    begin(const unsigned int node) const
    {
      return begins[node];
    }

    unsigned int
    size(const unsigned int node) const
    {
      return begins[node + 1] - begins[node];
    }

    unsigned int
    n_owned_unknowns() const
    {
      return begins[n_owned_nodes];
    }

    /// Numbers of the owned unknowns over all ranks.
    const IndexSet &
    owned_unknowns() const
    {
      return partitioner->locally_owned_range();
    }

    /// Number over all ranks of an entry of a vector.
    Index
    global_unknown(const unsigned int unknown) const
    {
      return partitioner->local_to_global(unknown);
    }

    unsigned int
    rank_of(const Index node) const;

    /// First node of each rank, and at last the number of all.
    const std::vector<Index> &
    first_nodes() const
    {
      return rank_begins;
    }

    /// Ranks that own nodes.
    unsigned int
    n_owners() const;

    const MPI_Comm &
    communicator() const
    {
      return comm;
    }

    /// The owned nodes that other ranks see, by rank: what they expect to be
    /// sent, in this order.
    const std::map<unsigned int, std::vector<Index>> &
    seen_elsewhere() const
    {
      return seen;
    }

    /// Fetches the values of the ghosts. Collective.
    void
    update_ghosts(std::vector<double> &vector) const;

    /// Adds the values of the ghosts to those of their owners and zeroes them.
    /// Collective.
    void
    add_ghosts_to_owners(std::vector<double> &vector) const;

  private:
    MPI_Comm                                           comm  = MPI_COMM_SELF;
    Index                                              first = 0;
    unsigned int                                       n_owned_nodes = 0;
    std::vector<Index>                                 rank_begins; ///< nodes
    std::vector<Index>                                 ghosts;
    std::vector<unsigned int>                          begins{0};
    std::map<unsigned int, std::vector<Index>>         seen;
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;
  };
} // namespace stickslip

#endif
