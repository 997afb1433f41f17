#ifndef stickslip_contact_surface_multiplier_numbering_h
#define stickslip_contact_surface_multiplier_numbering_h

#include <stickslip/base/types.h>

#include <deal.II/base/index_set.h>

#include <unordered_map>
#include <vector>

namespace stickslip
{
  /// Where the multipliers of one slave node stand.
  struct MultiplierNode
  {
    unsigned int            pair;
    types::global_dof_index key;       ///< first displacement dof of the node
    types::global_dof_index first_dof; ///< lambda_n; Lambda follows
  };

  /**
   * Numbers the multipliers (lambda_n, Lambda) of all contact pairs. A
   * multiplier node is a displacement node of a slave face and belongs to the
   * rank that owns the node's displacements; the numbers of a rank are
   * contiguous. There are no multipliers off the slave faces.
   */
  class MultiplierNumbering
  {
  public:
    MultiplierNumbering() = default;

    /**
     * @p keys[p] are the nodes of the locally owned slave faces of pair p
     * (first displacement dof of each, repetitions allowed) and
     * @p n_components[p] is 1 or dim. Collective.
     */
    MultiplierNumbering(
      const IndexSet &owned_displacements,
      const IndexSet &relevant_displacements,
      const std::vector<std::vector<types::global_dof_index>> &keys,
      const std::vector<unsigned int>                         &n_components,
      const MPI_Comm                                          &communicator);

    types::global_dof_index
    first_dof(const unsigned int pair, const types::global_dof_index key) const;

    bool
    has_node(const unsigned int pair, const types::global_dof_index key) const;

    /// Multipliers of this rank.
    const IndexSet &
    locally_owned() const
    {
      return owned;
    }

    /// Owned ones and those of all locally relevant nodes.
    const IndexSet &
    locally_relevant() const
    {
      return relevant;
    }

    const std::vector<MultiplierNode> &
    owned_nodes() const
    {
      return nodes;
    }

    /// Owned ones and those of all locally relevant nodes.
    const std::vector<MultiplierNode> &
    relevant_nodes() const
    {
      return all_nodes;
    }

    types::global_dof_index
    n_dofs() const
    {
      return owned.size();
    }

  private:
    IndexSet                    owned;
    IndexSet                    relevant;
    std::vector<MultiplierNode> nodes;
    std::vector<MultiplierNode> all_nodes;
    std::vector<
      std::unordered_map<types::global_dof_index, types::global_dof_index>>
      first_dofs;
  };
} // namespace stickslip

#endif
