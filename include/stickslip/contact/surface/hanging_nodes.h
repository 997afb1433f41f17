#ifndef stickslip_contact_surface_hanging_nodes_h
#define stickslip_contact_surface_hanging_nodes_h

#include <stickslip/contact/surface/surface_face.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <deal.II/dofs/dof_handler.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * Hanging multiplier nodes of a slave surface: on an edge of a coarser slave
   * face (3D; a line has none). Nodes are named by their first displacement
   * dof. Each is a combination of nodes of that edge, none of which hangs.
   */
  class HangingNodes
  {
  public:
    using Combination = std::vector<std::pair<types::global_dof_index, double>>;

    /// True if a node of a slave face that this rank owns or sees hangs.
    bool
    contains(const types::global_dof_index key) const
    {
      return keys.count(key) > 0;
    }

    const std::set<types::global_dof_index> &
    all() const
    {
      return keys;
    }

    /// What the node @p key hangs on, or nullptr: it does not hang, or its
    /// coarse face is out of sight. Not out of sight of the owner of the node
    /// and of those of its faces.
    const Combination *
    combination(const types::global_dof_index key) const
    {
      const auto found = combinations.find(key);
      return found == combinations.end() ? nullptr : &found->second;
    }

    /// Those of @p slave_faces, which are those that this rank owns and their
    /// ghosts, for multipliers of degree 1 or that of the displacements.
    /// Collective.
    template <int dim>
    static HangingNodes
    find(const DoFHandler<dim>                 &dof_handler,
         const unsigned int                     multiplier_degree,
         const std::vector<CollectedFace<dim>> &slave_faces);

  private:
    std::set<types::global_dof_index>              keys;
    std::map<types::global_dof_index, Combination> combinations;
  };



  /// The node of a face at the vertex that its cell shares with its parent, or
  /// an invalid one: no parent, or not on the face. All hanging nodes of a
  /// boundary face are on its edges through that vertex.
  template <int dim>
  types::global_dof_index
  node_shared_with_parent(const CollectedFace<dim> &face);



  /// Which of the multiplier nodes @p keys of a face are @p excluded or hang;
  /// the heir of those that hang is @p shared, the node on which they do.
  MissingNodes
  missing_nodes(const std::vector<types::global_dof_index> &keys,
                const std::set<types::global_dof_index>    &excluded,
                const HangingNodes                         &hanging,
                const types::global_dof_index               shared);
} // namespace stickslip

#endif
