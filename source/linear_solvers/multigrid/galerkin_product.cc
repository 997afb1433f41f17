#include <stickslip/linear_solvers/multigrid/galerkin_product.h>
#include <stickslip/linear_solvers/multigrid/product_row.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;

    /// Rows of the owned nodes and, behind them, of the ghosts of @p space.
    template <typename Number>
    BlockRows<Number>
    local_rows(const BlockRows<Number> &owned, const NodeSpace &space)
    {
      BlockRows<Number> rows   = owned;
      const auto        ghosts = ghost_rows(owned, space);
      for (unsigned int row = 0; row < ghosts.n_rows(); ++row)
        rows.append(ghosts, row);
      return rows;
    }



    template <typename Number>
    std::vector<unsigned int>
    local_columns(const BlockRows<Number> &rows, const NodeSpace &space)
    {
      std::vector<unsigned int> columns;
      columns.reserve(rows.columns.size());
      for (const Index column : rows.columns)
        columns.push_back(space.local(column));
      return columns;
    }



    /// The space of the columns of P with those of @p rows as ghosts.
    template <typename Number>
    NodeSpace
    seen_space(const NodeSpace &coarse, const BlockRows<Number> &rows)
    {
      NodeSpace space(coarse);
      space.set_ghosts(foreign_columns(rows, space));
      return space;
    }



    /// P^T A P with entries still zero, for all local coarse nodes.
    template <typename Number>
    BlockRows<double>
    galerkin_pattern(const BlockMatrix               &A,
                     const BlockRows<Number>         &P,
                     const std::vector<unsigned int> &columns,
                     const NodeSpace                 &space)
    {
      std::vector<std::vector<unsigned int>> rows_of(space.n_local());
      for (unsigned int row = 0; row < A.n_rows(); ++row)
        for (auto l = P.column_begins[row]; l < P.column_begins[row + 1]; ++l)
          rows_of[columns[l]].push_back(row);

      BlockRows<double> result;
      RowPattern        pattern(space);
      for (unsigned int coarse_row = 0; coarse_row < space.n_local();
           ++coarse_row)
        {
          pattern.clear();
          for (const unsigned int row : rows_of[coarse_row])
            for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
              for (auto l = P.column_begins[A.column(k)];
                   l < P.column_begins[A.column(k) + 1];
                   ++l)
                pattern.insert(columns[l]);
          pattern.arrange();
          for (const unsigned int node : pattern.nodes)
            {
              result.columns.push_back(space.global(node));
              result.widths.push_back(space.size(node));
            }
          result.end_row(space.size(coarse_row));
        }
      result.allocate();
      return result;
    }



    /// Adds the transposed of the block @p a of P times @p product, its row of
    /// A P, to row @p row of the result. Rows of P begin @p a_stride apart.
    template <typename Number>
    void
    add_to_row(const Number      *a,
               const unsigned int a_stride,
               const unsigned int n_inner,
               const ProductRow  &product,
               const NodeSpace   &space,
               const unsigned int row,
               BlockRows<double> &result)
    {
      const std::vector<unsigned int> &nodes  = product.pattern.nodes;
      const unsigned int               width  = result.width(row);
      auto                             k      = result.column_begins[row];
      double                          *target = result.panel(row);
      for (unsigned int i = 0; i < nodes.size();)
        {
          for (; result.columns[k] != space.global(nodes[i]); ++k)
            target += result.widths[k];
          // blocks that are side by side in the result, too
          const unsigned int offset = product.pattern.offset(nodes[i]);
          unsigned int       n      = 0;
          do
            {
              n += result.widths[k++];
              ++i;
          } while (i < nodes.size() &&
                   result.columns[k] == space.global(nodes[i]));
          const PanelProduct panel{
            space.size(row), n_inner, n, 1, a_stride, product.width, width};
          panel.add(a, product.values.data() + offset, target);
          target += n;
        }
    }



    /// Rows of nodes from those of their clusters.
    BlockRows<float>
    rows_of_nodes(const BlockRows<float> &of_clusters,
                  const BlockMatrix      &A,
                  const NodeClusters     &clusters)
    {
      std::vector<std::size_t> begins(A.n_rows());
      for (unsigned int cluster = 0; cluster < clusters.n(); ++cluster)
        {
          std::size_t begin = of_clusters.value_begins[cluster];
          for (const unsigned int node : clusters.nodes(cluster))
            {
              begins[node] = begin;
              begin += A.height(node) * of_clusters.width(cluster);
            }
        }
      BlockRows<float> rows;
      for (unsigned int node = 0; node < A.n_rows(); ++node)
        {
          const unsigned int cluster = clusters.of_node[node];
          const auto         begin   = of_clusters.column_begins[cluster],
                     end             = of_clusters.column_begins[cluster + 1];
          rows.columns.insert(rows.columns.end(),
                              of_clusters.columns.begin() + begin,
                              of_clusters.columns.begin() + end);
          rows.widths.insert(rows.widths.end(),
                             of_clusters.widths.begin() + begin,
                             of_clusters.widths.begin() + end);
          rows.end_row(A.height(node));
        }
      rows.allocate();
      for (unsigned int node = 0; node < A.n_rows(); ++node)
        std::copy_n(of_clusters.values.begin() + begins[node],
                    rows.value_begins[node + 1] - rows.value_begins[node],
                    rows.panel(node));
      return rows;
    }
  } // namespace



  BlockRows<float>
  smoothed_prolongation(const BlockMatrix       &A,
                        const BlockGaussSeidel  &smoother,
                        const BlockRows<double> &tentative,
                        const NodeSpace         &coarse)
  {
    const double            omega = 4. / 3. / smoother.largest_eigenvalue();
    const BlockRows<double> P0    = local_rows(tentative, A.column_space());
    const NodeSpace         space = seen_space(coarse, P0);
    const std::vector<unsigned int> columns = local_columns(P0, space);
    ProductRow                      product(space);
    const NodeClusters             &clusters = smoother.node_clusters();

    // a row for each cluster, whose nodes have the same columns
    BlockRows<float>    of_clusters;
    std::vector<double> column;
    for (unsigned int cluster = 0; cluster < clusters.n(); ++cluster)
      {
        product.compute(A, P0, columns, clusters.nodes(cluster));
        for (const unsigned int node : product.pattern.nodes)
          {
            of_clusters.columns.push_back(space.global(node));
            of_clusters.widths.push_back(space.size(node));
          }
        const unsigned int width  = product.width;
        auto              &values = product.values;
        const unsigned int height = width > 0 ? values.size() / width : 0;
        of_clusters.end_row(height);
        of_clusters.allocate();
        column.resize(height);
        for (unsigned int c = 0; c < width; ++c)
          {
            for (unsigned int r = 0; r < height; ++r)
              column[r] = values[r * width + c];
            smoother.scale(cluster, column.data());
            for (unsigned int r = 0; r < height; ++r)
              values[r * width + c] = -omega * column[r];
          }
        double *sum = values.data();
        for (const unsigned int node : clusters.nodes(cluster))
          {
            // at most one block
            for (auto l = P0.column_begins[node];
                 l < P0.column_begins[node + 1];
                 ++l)
              add_block(P0.panel(node),
                        P0.widths[l],
                        A.height(node),
                        P0.widths[l],
                        sum + product.pattern.offset(columns[l]),
                        width);
            sum += A.height(node) * width;
          }
        std::copy(values.begin(), values.end(), of_clusters.panel(cluster));
      }
    return clusters.n() == A.n_rows() ? std::move(of_clusters)
                                      : rows_of_nodes(of_clusters, A, clusters);
  }



  template <typename Number>
  BlockRows<double>
  galerkin_product(const BlockMatrix       &A,
                   const BlockRows<Number> &prolongation,
                   const NodeSpace         &coarse)
  {
    const BlockRows<Number> P     = local_rows(prolongation, A.column_space());
    const NodeSpace         space = seen_space(coarse, P);
    const std::vector<unsigned int> columns = local_columns(P, space);
    BlockRows<double> result = galerkin_pattern(A, P, columns, space);
    ProductRow        product(space);
    for (unsigned int row = 0; row < A.n_rows(); ++row)
      {
        product.compute(A, P, columns, ArrayView<const unsigned int>(&row, 1));
        const unsigned int stride = P.width(row);
        const Number      *block  = P.panel(row);
        for (auto l = P.column_begins[row]; l < P.column_begins[row + 1]; ++l)
          {
            add_to_row(
              block, stride, A.height(row), product, space, columns[l], result);
            block += P.widths[l];
          }
      }
    return sum_to_owners(std::move(result), space);
  }



  template BlockRows<double>
  galerkin_product(const BlockMatrix &,
                   const BlockRows<float> &,
                   const NodeSpace &);
  template BlockRows<double>
  galerkin_product(const BlockMatrix &,
                   const BlockRows<double> &,
                   const NodeSpace &);
} // namespace stickslip
