#include <stickslip/linear_solvers/multigrid/node_clusters.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    /// Neighbours at less than this share of the cell size are close.
    constexpr double close = 0.5;

    /// How far a cluster reaches from its first node, in cell sizes. (With 1
    /// cells of 8 : 8 : 1 take a quarter more iterations, quadratic ones 40 %.)
    constexpr double reach = 1.5;

    /// Unknowns of a cluster, at most: its inverse is dense. (With 96
    /// quadratic cells of 8 : 1 : 1 take a quarter less iterations and 15 %
    /// less time, all others the same.)
    constexpr unsigned int largest_cluster = 48;
    static_assert(largest_cluster < 256, "widths of blocks are bytes");



    /// The neighbours of a node in its rank, body and cells.
    template <typename Visitor>
    void
    visit_neighbours(const BlockMatrix &matrix,
                     const NodePlaces  &places,
                     const unsigned int node,
                     const Visitor     &visit)
    {
      for (auto k = matrix.column_begin(node);
           k < matrix.column_begin(node + 1);
           ++k)
        {
          const unsigned int other = matrix.column(k);
          if (other != node && other < matrix.n_rows() &&
              places.may_share_cell(node, other))
            visit(other);
        }
    }



    /// The size of the cells around each node: between cubes the median of the
    /// distances of its neighbours is the diagonal of a face.
    std::vector<double>
    cell_sizes(const BlockMatrix &matrix, const NodePlaces &places)
    {
      std::vector<double> sizes, distances;
      for (unsigned int node = 0; node < matrix.n_rows(); ++node)
        {
          distances.clear();
          visit_neighbours(matrix, places, node, [&](const unsigned int other) {
            distances.push_back(
              places.positions[node].distance(places.positions[other]));
          });
          sizes.push_back(0.);
          if (distances.empty())
            continue;
          const auto middle = distances.begin() + distances.size() / 2;
          std::nth_element(distances.begin(), middle, distances.end());
          sizes.back() = *middle / std::sqrt(2.);
        }
      return sizes;
    }
  } // namespace



  NodeClusters
  single_nodes(const unsigned int n)
  {
    NodeClusters clusters;
    for (unsigned int node = 0; node < n; ++node)
      {
        clusters.of_node.push_back(node);
        clusters.members.push_back(node);
        clusters.begins.push_back(node + 1);
      }
    return clusters;
  }



  NodeClusters
  find_clusters(const BlockMatrix &matrix, const NodePlaces &places)
  {
    if (places.positions.empty())
      return single_nodes(matrix.n_rows());
    const std::vector<double> sizes = cell_sizes(matrix, places);
    constexpr unsigned int    none  = numbers::invalid_unsigned_int;
    NodeClusters              clusters;
    clusters.of_node.assign(matrix.n_rows(), none);
    for (unsigned int seed = 0; seed < matrix.n_rows(); ++seed)
      {
        if (clusters.of_node[seed] != none)
          continue;
        const Point<3> &place      = places.positions[seed];
        unsigned int    n_unknowns = 0;
        const auto      add        = [&](const unsigned int node) {
          clusters.of_node[node] = clusters.n();
          clusters.members.push_back(node);
          n_unknowns += matrix.height(node);
        };
        add(seed);
        // breadth first
        for (auto k = clusters.begins.back(); k < clusters.members.size(); ++k)
          {
            const unsigned int node = clusters.members[k];
            visit_neighbours(
              matrix, places, node, [&](const unsigned int other) {
                const Point<3> &there = places.positions[other];
                if (clusters.of_node[other] == none &&
                    n_unknowns + matrix.height(other) <= largest_cluster &&
                    place.distance(there) <= reach * sizes[seed] &&
                    places.positions[node].distance(there) <=
                      close * std::min(sizes[node], sizes[other]))
                  add(other);
              });
          }
        clusters.begins.push_back(clusters.members.size());
      }
    return clusters;
  }
} // namespace stickslip
