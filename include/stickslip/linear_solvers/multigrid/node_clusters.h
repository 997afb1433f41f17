#ifndef stickslip_linear_solvers_multigrid_node_clusters_h
#define stickslip_linear_solvers_multigrid_node_clusters_h

#include <stickslip/base/block_system.h>

#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <deal.II/base/array_view.h>

#include <vector>

namespace stickslip
{
  /// Owned nodes of a level in groups that a smoother solves for at once.
  struct NodeClusters
  {
    std::vector<unsigned int> of_node;
    std::vector<std::size_t>  begins{0};
    std::vector<unsigned int> members; ///< by cluster

    unsigned int
    n() const
    {
      return begins.size() - 1;
    }

    /// Whether a local node (which may be a ghost) belongs to a cluster.
    bool
    has(const unsigned int cluster, const unsigned int node) const
    {
      return node < of_node.size() && of_node[node] == cluster;
    }

    ArrayView<const unsigned int>
    nodes(const unsigned int cluster) const
    {
      return ArrayView<const unsigned int>(members.data() + begins[cluster],
                                           begins[cluster + 1] -
                                             begins[cluster]);
    }
  };



  /// Each of @p n nodes by itself.
  NodeClusters
  single_nodes(const unsigned int n);



  /**
   * Clusters of nodes that are close to each other beside their other
   * neighbours: those of one rank and body across the thickness of flat or long
   * cells, about as many as make the cluster as thick as cells are long. What
   * is left between clusters has the same size in all directions, for a
   * smoother, and for aggregates of clusters; nodes of cells with edges of
   * similar length stay by themselves. Without positions all do.
   *
   * Stiffness itself says less: a trilinear cell that is long in one direction
   * couples nodes along it more than across (by its positive entries).
   */
  NodeClusters
  find_clusters(const BlockMatrix &matrix, const NodePlaces &places);
} // namespace stickslip

#endif
