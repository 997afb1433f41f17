#include <stickslip/linear_solvers/multigrid/aggregation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// A mode that is a combination of others up to this share of its length
    /// adds nothing. (The rotations of a small aggregate are its size beside
    /// that of the model.)
    constexpr double dependent = 1e-10;



    /**
     * What an aggregate may be made of: clusters of a rank and body with nodes
     * in the same cells. (With all that the matrix couples aggregates of thin
     * plates in contact are twice as wide: stiffness of contact reaches over
     * three cells of a surface, and each cluster across a plate is at one. Such
     * plates took 2.4 times the iterations.)
     */
    class Neighbourhoods
    {
    public:
      Neighbourhoods(const BlockMatrix  &matrix,
                     const NodeClusters &clusters,
                     const NodePlaces   &places)
      {
        AssertDimension(places.bodies.size(), matrix.n_rows());
        // the last one that a cluster has been found beside
        std::vector<unsigned int> seen_from(clusters.n(), Aggregates::none);
        for (unsigned int cluster = 0; cluster < clusters.n(); ++cluster)
          {
            bool is_alone = true;
            for (const unsigned int node : clusters.nodes(cluster))
              for (auto k = matrix.column_begin(node);
                   k < matrix.column_begin(node + 1);
                   ++k)
                {
                  const unsigned int other = matrix.column(k);
                  is_alone                 = is_alone && other == node;
                  if (other >= matrix.n_rows() ||
                      clusters.of_node[other] == cluster ||
                      !places.may_share_cell(node, other))
                    continue;
                  unsigned int &last = seen_from[clusters.of_node[other]];
                  if (last != cluster)
                    neighbours.push_back(clusters.of_node[other]);
                  last = cluster;
                }
            coupled.push_back(!is_alone);
            begins.push_back(neighbours.size());
          }
      }

      unsigned int
      n() const
      {
        return coupled.size();
      }

      template <typename Visitor>
      void
      visit(const unsigned int cluster, const Visitor &visitor) const
      {
        for (auto k = begins[cluster]; k < begins[cluster + 1]; ++k)
          visitor(neighbours[k]);
      }

      /// Whether a cluster has more than a node without couplings, to whatever
      /// rank and body.
      bool
      is_coupled(const unsigned int cluster) const
      {
        return coupled[cluster];
      }

    private:
      std::vector<std::size_t>  begins{0};
      std::vector<unsigned int> neighbours;
      std::vector<bool>         coupled;
    };



    void
    aggregate_free_neighbourhoods(const Neighbourhoods &neighbourhoods,
                                  Aggregates           &aggregates)
    {
      auto &of_cluster = aggregates.of_node; // as long as clusters count
      for (unsigned int cluster = 0; cluster < of_cluster.size(); ++cluster)
        {
          bool is_free = of_cluster[cluster] == Aggregates::none &&
                         neighbourhoods.is_coupled(cluster);
          neighbourhoods.visit(cluster, [&](const unsigned int other) {
            is_free = is_free && of_cluster[other] == Aggregates::none;
          });
          if (!is_free)
            continue;
          of_cluster[cluster] = aggregates.n;
          neighbourhoods.visit(cluster, [&](const unsigned int other) {
            of_cluster[other] = aggregates.n;
          });
          ++aggregates.n;
        }
    }



    void
    join_neighbours(const Neighbourhoods &neighbourhoods,
                    Aggregates           &aggregates)
    {
      const std::vector<unsigned int> first = aggregates.of_node;
      std::vector<unsigned int>       connections(aggregates.n, 0);
      for (unsigned int cluster = 0; cluster < first.size(); ++cluster)
        {
          if (first[cluster] != Aggregates::none)
            continue;
          unsigned int &best = aggregates.of_node[cluster];
          neighbourhoods.visit(cluster, [&](const unsigned int other) {
            if (first[other] != Aggregates::none)
              {
                const unsigned int n = ++connections[first[other]];
                if (best == Aggregates::none || n > connections[best])
                  best = first[other];
              }
          });
          neighbourhoods.visit(cluster, [&](const unsigned int other) {
            if (first[other] != Aggregates::none)
              connections[first[other]] = 0;
          });
        }
    }



    void
    aggregate_rest(const Neighbourhoods &neighbourhoods, Aggregates &aggregates)
    {
      auto &of_cluster = aggregates.of_node; // as long as clusters count
      for (unsigned int cluster = 0; cluster < of_cluster.size(); ++cluster)
        {
          if (of_cluster[cluster] != Aggregates::none ||
              !neighbourhoods.is_coupled(cluster))
            continue;
          of_cluster[cluster] = aggregates.n;
          neighbourhoods.visit(cluster, [&](const unsigned int other) {
            if (of_cluster[other] == Aggregates::none)
              of_cluster[other] = aggregates.n;
          });
          ++aggregates.n;
        }
    }



    /// Appends the place of an aggregate of @p nodes.
    void
    add_place(const std::vector<unsigned int> &nodes,
              const NodePlaces                &fine,
              NodePlaces                      &coarse)
    {
      coarse.bodies.push_back(fine.bodies[nodes.front()]);
      if (fine.positions.empty())
        return;
      Point<3> sum;
      for (const unsigned int node : nodes)
        sum += fine.positions[node];
      coarse.positions.push_back(sum / static_cast<double>(nodes.size()));
    }



    double
    product(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }



    /// Gram-Schmidt, twice: orthonormal columns Q and the coefficients R of
    /// @p columns in them, R[q][column].
    void
    orthonormalize(const std::vector<std::vector<double>> &columns,
                   std::vector<std::vector<double>>       &Q,
                   std::vector<std::vector<double>>       &R)
    {
      Q.clear();
      R.clear();
      for (unsigned int c = 0; c < columns.size(); ++c)
        {
          std::vector<double> rest   = columns[c];
          const double        length = std::sqrt(product(rest, rest));
          for (unsigned int pass = 0; pass < 2; ++pass)
            for (unsigned int q = 0; q < Q.size(); ++q)
              {
                const double share = product(Q[q], rest);
                R[q][c] += share;
                for (unsigned int i = 0; i < rest.size(); ++i)
                  rest[i] -= share * Q[q][i];
              }
          const double rest_length = std::sqrt(product(rest, rest));
          if (rest_length <= dependent * length)
            continue;
          for (double &value : rest)
            value /= rest_length;
          Q.push_back(rest);
          R.emplace_back(columns.size(), 0.);
          R.back()[c] = rest_length;
        }
    }
  } // namespace



  Aggregates
  find_aggregates(const BlockMatrix  &matrix,
                  const NodeClusters &clusters,
                  const NodePlaces   &places)
  {
    const Neighbourhoods neighbourhoods(matrix, clusters, places);
    Aggregates           aggregates; // of clusters, first
    aggregates.of_node.assign(neighbourhoods.n(), Aggregates::none);
    aggregate_free_neighbourhoods(neighbourhoods, aggregates);
    join_neighbours(neighbourhoods, aggregates);
    aggregate_rest(neighbourhoods, aggregates);
    std::vector<unsigned int> of_node;
    for (const unsigned int cluster : clusters.of_node)
      of_node.push_back(aggregates.of_node[cluster]);
    aggregates.of_node = std::move(of_node);
    return aggregates;
  }



  void
  set_reaches(const BlockMatrix &matrix,
              const NodePlaces  &fine,
              const Aggregates  &aggregates,
              NodePlaces        &coarse)
  {
    coarse.reaches.clear();
    if (fine.reaches.empty())
      return;
    coarse.reaches.assign(aggregates.n, 0.);
    for (unsigned int node = 0; node < matrix.n_rows(); ++node)
      for (auto k = matrix.column_begin(node);
           k < matrix.column_begin(node + 1);
           ++k)
        {
          const unsigned int other = matrix.column(k);
          if (other >= matrix.n_rows() || !fine.may_share_cell(node, other))
            continue;
          const unsigned int a = aggregates.of_node[node],
                             b = aggregates.of_node[other];
          if (a == b || a == Aggregates::none || b == Aggregates::none)
            continue;
          const double distance =
            coarse.positions[a].distance(coarse.positions[b]);
          for (const unsigned int aggregate : {a, b})
            coarse.reaches[aggregate] =
              std::max(coarse.reaches[aggregate], distance);
        }
    // neighbours of other ranks are not known
    for (double &reach : coarse.reaches)
      if (reach == 0.)
        reach = std::numeric_limits<double>::max();
  }



  TentativeProlongation
  tentative_prolongation(const NodeSpace  &fine,
                         const Aggregates &aggregates,
                         const Modes      &modes)
  {
    const unsigned int                     n_vectors = modes.n_vectors;
    std::vector<std::vector<unsigned int>> nodes(aggregates.n);
    for (unsigned int node = 0; node < fine.n_owned(); ++node)
      if (aggregates.of_node[node] != Aggregates::none)
        nodes[aggregates.of_node[node]].push_back(node);

    TentativeProlongation            result;
    std::vector<std::vector<double>> Q, R, columns(n_vectors);
    std::vector<double>              basis; // by fine unknown, of each rank
    std::vector<std::size_t>         basis_begins(fine.n_owned(), 0);
    std::vector<unsigned int>        ranks(aggregates.n);
    result.coarse_modes.n_vectors = n_vectors;
    for (unsigned int a = 0; a < aggregates.n; ++a)
      {
        for (unsigned int v = 0; v < n_vectors; ++v)
          {
            columns[v].clear();
            for (const unsigned int node : nodes[a])
              for (unsigned int i = fine.begin(node); i < fine.begin(node + 1);
                   ++i)
                columns[v].push_back(modes.values[i * n_vectors + v]);
          }
        orthonormalize(columns, Q, R);
        ranks[a] = Q.size();
        add_place(nodes[a], modes.nodes, result.coarse_modes.nodes);
        for (const auto &row : R)
          result.coarse_modes.values.insert(result.coarse_modes.values.end(),
                                            row.begin(),
                                            row.end());
        unsigned int i = 0; // in the aggregate
        for (const unsigned int node : nodes[a])
          {
            basis_begins[node] = basis.size();
            for (unsigned int r = 0; r < fine.size(node); ++r, ++i)
              for (const auto &q : Q)
                basis.push_back(q[i]);
          }
      }

    result.coarse = NodeSpace(ranks, fine.communicator());
    for (unsigned int node = 0; node < fine.n_owned(); ++node)
      {
        const unsigned int a = aggregates.of_node[node];
        if (a == Aggregates::none)
          {
            result.rows.end_row(fine.size(node));
            continue;
          }
        result.rows.columns.push_back(result.coarse.global(a));
        result.rows.widths.push_back(ranks[a]);
        result.rows.end_row(fine.size(node));
        result.rows.allocate();
        std::copy_n(basis.begin() + basis_begins[node],
                    fine.size(node) * ranks[a],
                    result.rows.panel(node));
      }
    return result;
  }
} // namespace stickslip
