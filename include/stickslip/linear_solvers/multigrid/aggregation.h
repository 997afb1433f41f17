#ifndef stickslip_linear_solvers_multigrid_aggregation_h
#define stickslip_linear_solvers_multigrid_aggregation_h

#include <stickslip/linear_solvers/multigrid/node_clusters.h>

#include <vector>

namespace stickslip
{
  /// Groups of nodes of one rank that a coarse node will stand for.
  struct Aggregates
  {
    static constexpr unsigned int none = -1;

    unsigned int              n = 0;
    std::vector<unsigned int> of_node; ///< none: no neighbours, needs no coarse
                                       ///< level
  };



  /**
   * Aggregates of clusters with nodes in the same cells, within each rank and
   * body: clusters whose neighbourhood is free with this neighbourhood, then
   * the others with the neighbouring aggregate that they have most connections
   * with (Vanek, Mandel, Brezina 1996). What is left makes aggregates of its
   * own. (Aggregates across contact need the motions of both bodies, so that
   * they are not smaller, and take up to a tenth more iterations.)
   */
  Aggregates
  find_aggregates(const BlockMatrix  &matrix,
                  const NodeClusters &clusters,
                  const NodePlaces   &places);



  /// Sets the reaches of @p coarse places: the largest distance to an aggregate
  /// that has nodes in the same cells. @p matrix and @p fine are those of the
  /// level that the aggregates are made of.
  void
  set_reaches(const BlockMatrix &matrix,
              const NodePlaces  &fine,
              const Aggregates  &aggregates,
              NodePlaces        &coarse);



  /// Vectors that the coarse levels have to represent: [unknown * n_vectors +
  /// vector] for the owned unknowns.
  struct Modes
  {
    unsigned int        n_vectors = 0;
    std::vector<double> values;
    NodePlaces          nodes;
  };



  /// What the modes become in aggregates.
  struct TentativeProlongation
  {
    NodeSpace         coarse; ///< a node for each aggregate
    BlockRows<double> rows;   ///< at most one block in each
    Modes             coarse_modes;
  };



  /**
   * An orthonormal basis of the modes in each aggregate, with as many columns
   * as there are independent modes: six in space, less beside supports.
   * Collective.
   */
  TentativeProlongation
  tentative_prolongation(const NodeSpace  &fine,
                         const Aggregates &aggregates,
                         const Modes      &modes);
} // namespace stickslip

#endif
