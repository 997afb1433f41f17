#ifndef stickslip_mesh_periodic_nodes_h
#define stickslip_mesh_periodic_nodes_h

#include <stickslip/base/types.h>

#include <stickslip/mesh/periodicity.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <map>
#include <vector>

namespace stickslip
{
  /**
   * The nodes on periodic boundaries that are images of other nodes, their
   * originals: their displacements are those of the original, turned. Of all
   * places of a node the one with the smallest dof is the original, the same on
   * all ranks.
   *
   * Not deal.II's make_periodicity_constraints(): where a rotation leaves one
   * component as it is, that one may be constrained the other way round than
   * the others, and a node be the original in a part of its components.
   */
  template <int dim>
  class PeriodicNodes
  {
  public:
    struct Image
    {
      types::global_dof_index original; ///< its first dof
      PeriodicMotion          motion;   ///< of the original to this node
    };

    PeriodicNodes() = default;

    /// Of the locally relevant nodes. Collective.
    PeriodicNodes(const std::vector<PeriodicBoundary> &boundaries,
                  const hp::MappingCollection<dim>    &mapping,
                  const DoFHandler<dim>               &dof_handler);

    /// Whether the model has periodic boundaries: the same on all ranks.
    bool
    has_boundaries() const
    {
      return is_periodic;
    }

    /// By the first dof of the node.
    const std::map<types::global_dof_index, Image> &
    images() const
    {
      return nodes;
    }

    /// Adds the lines of all images that @p lines may have.
    void
    add_lines(Constraints &lines) const;

  private:
    std::map<types::global_dof_index, Image> nodes;
    bool                                     is_periodic = false;
  };
} // namespace stickslip

#endif
