#include <stickslip/linear_solvers/multigrid/block_diagonal.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Pivots below this share of their diagonal entry are zero.
    constexpr double zero_pivot = 1e-12;

    /// Gauss-Jordan in place; without pivoting, as the blocks are definite.
    void
    invert(double *const a, const unsigned int n)
    {
      std::vector<double> diagonal(n);
      for (unsigned int k = 0; k < n; ++k)
        diagonal[k] = a[k * n + k];
      for (unsigned int k = 0; k < n; ++k)
        {
          const double pivot = a[k * n + k];
          if (std::abs(pivot) <= zero_pivot * std::abs(diagonal[k]))
            {
              for (unsigned int i = 0; i < n; ++i)
                a[k * n + i] = a[i * n + k] = 0.;
              continue;
            }
          a[k * n + k] = 1.;
          for (unsigned int j = 0; j < n; ++j)
            a[k * n + j] /= pivot;
          for (unsigned int i = 0; i < n; ++i)
            if (i != k)
              {
                const double factor = a[i * n + k];
                a[i * n + k]        = 0.;
                for (unsigned int j = 0; j < n; ++j)
                  a[i * n + j] -= factor * a[k * n + j];
              }
        }
    }



    /// The block of a cluster by rows. @p offsets is memory by node.
    std::vector<double>
    diagonal_block(const BlockMatrix         &A,
                   const NodeClusters        &clusters,
                   const unsigned int         cluster,
                   const unsigned int         size,
                   std::vector<unsigned int> &offsets)
    {
      const auto   nodes  = clusters.nodes(cluster);
      unsigned int height = 0;
      for (const unsigned int node : nodes)
        {
          offsets[node] = height;
          height += A.height(node);
        }
      std::vector<double> block(size * size, 0.);
      for (const unsigned int node : nodes)
        {
          bool          has_diagonal = false;
          const double *panel        = A.panel(node);
          for (auto k = A.column_begin(node); k < A.column_begin(node + 1); ++k)
            {
              const unsigned int other = A.column(k);
              has_diagonal             = has_diagonal || other == node;
              if (clusters.has(cluster, other))
                for (unsigned int r = 0; r < A.height(node); ++r)
                  std::copy_n(panel + r * A.width(node),
                              A.block_width(k),
                              block.begin() + (offsets[node] + r) * size +
                                offsets[other]);
              panel += A.block_width(k);
            }
          AssertThrow(has_diagonal, ExcMessage("A diagonal block is zero."));
        }
      return block;
    }
  } // namespace



  void
  BlockDiagonal::reinit(const BlockMatrix &A, const NodeClusters &clusters)
  {
    sizes.clear();
    is_single.clear();
    single_nodes.clear();
    begins.clear();
    largest = 0;
    BlockRows<float>          rows;
    std::vector<unsigned int> offsets(A.n_rows());
    for (unsigned int cluster = 0; cluster < clusters.n(); ++cluster)
      {
        unsigned int size = 0;
        for (const unsigned int node : clusters.nodes(cluster))
          size += A.height(node);
        sizes.push_back(size);
        largest = std::max(largest, size);
        is_single.push_back(clusters.nodes(cluster).size() == 1);
        begins.push_back(single_nodes.size());
        std::vector<double> block =
          diagonal_block(A, clusters, cluster, size, offsets);
        invert(block.data(), size);
        if (is_single.back())
          single_nodes.insert(single_nodes.end(), block.begin(), block.end());
        else
          {
            rows.columns.push_back(0); // what it is multiplied with
            rows.widths.push_back(size);
            rows.values.insert(rows.values.end(), block.begin(), block.end());
          }
        rows.column_begins.push_back(rows.columns.size());
        rows.value_begins.push_back(rows.values.size());
      }
    of_clusters = CycleMatrix(std::move(rows), A.column_space());
  }



  void
  BlockDiagonal::solve(const unsigned int         cluster,
                       const std::vector<double> &b,
                       double                    *x) const
  {
    const unsigned int n = sizes[cluster];
    if (!is_single[cluster])
      {
        std::fill_n(x, n, 0.);
        of_clusters.add_product(cluster, 1., b, x);
        return;
      }
    const double *block = single_nodes.data() + begins[cluster];
    for (unsigned int r = 0; r < n; ++r, block += n)
      {
        double sum = 0.;
        for (unsigned int c = 0; c < n; ++c)
          sum += block[c] * b[c];
        x[r] = sum;
      }
  }
} // namespace stickslip
