#include <stickslip/linear_solvers/multigrid/galerkin_product.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;

    constexpr unsigned int absent = -1;



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



    /**
     * A row of blocks that is a sum of others: where each column node is in it.
     * The nodes are given by local numbers.
     */
    class RowPattern
    {
    public:
      explicit RowPattern(const NodeSpace &space)
        : space(space)
        , offsets(space.n_local(), absent)
      {}

      void
      clear()
      {
        for (const unsigned int node : nodes)
          offsets[node] = absent;
        nodes.clear();
      }

      void
      insert(const unsigned int node)
      {
        if (offsets[node] == absent)
          {
            offsets[node] = 0;
            nodes.push_back(node);
          }
      }

      /// Ends the insertions: sorts the nodes by their global numbers. Returns
      /// the width of the row.
      unsigned int
      arrange()
      {
        std::sort(nodes.begin(),
                  nodes.end(),
                  [&](const unsigned int a, const unsigned int b) {
                    return space.global(a) < space.global(b);
                  });
        unsigned int width = 0;
        for (const unsigned int node : nodes)
          {
            offsets[node] = width;
            width += space.size(node);
          }
        return width;
      }

      unsigned int
      offset(const unsigned int node) const
      {
        return offsets[node];
      }

      std::vector<unsigned int> nodes;

    private:
      const NodeSpace          &space;
      std::vector<unsigned int> offsets;
    };



    /// sum += a b for blocks in panels with the given strides.
    template <typename Number>
    void
    add_product(const double      *a,
                const unsigned int a_stride,
                const Number      *b,
                const unsigned int b_stride,
                double            *sum,
                const unsigned int sum_stride,
                const unsigned int n_rows,
                const unsigned int n_inner,
                const unsigned int n_columns)
    {
      for (unsigned int i = 0; i < n_rows; ++i)
        for (unsigned int k = 0; k < n_inner; ++k)
          {
            const double value = a[i * a_stride + k];
            for (unsigned int j = 0; j < n_columns; ++j)
              sum[i * sum_stride + j] += value * b[k * b_stride + j];
          }
    }



    /// Row @p row of A P: @p columns are the local numbers of the columns of
    /// @p P.
    template <typename Number>
    void
    product_row(const BlockMatrix<double>       &A,
                const BlockRows<Number>         &P,
                const std::vector<unsigned int> &columns,
                const unsigned int               row,
                RowPattern                      &pattern,
                std::vector<double>             &values)
    {
      const auto visit_parts = [&](const auto &visit) {
        for (auto k = A.column_begin(row); k < A.column_begin(row + 1); ++k)
          visit(k, A.column(k));
      };
      pattern.clear();
      visit_parts([&](const auto, const unsigned int j) {
        for (auto l = P.column_begins[j]; l < P.column_begins[j + 1]; ++l)
          pattern.insert(columns[l]);
      });
      const unsigned int width = pattern.arrange();
      values.assign(A.height(row) * width, 0.);
      const double *block = A.panel(row);
      visit_parts([&](const std::size_t k, const unsigned int j) {
        const Number      *part   = P.panel(j);
        const unsigned int stride = P.width(j);
        for (auto l = P.column_begins[j]; l < P.column_begins[j + 1]; ++l)
          {
            add_product(block,
                        A.width(row),
                        part,
                        stride,
                        values.data() + pattern.offset(columns[l]),
                        width,
                        A.height(row),
                        A.block_width(k),
                        P.widths[l]);
            part += P.widths[l];
          }
        block += A.block_width(k);
      });
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
    BlockRows<double>
    galerkin_pattern(const BlockMatrix<double>       &A,
                     const BlockRows<float>          &P,
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


    /// Adds P_K^T times @p product to row @p coarse_row of the result, where
    /// P_K is a block of the panel @p part.
    void
    add_to_row(const float               *part,
               const unsigned int         part_stride,
               const unsigned int         height,
               const RowPattern          &pattern,
               const unsigned int         product_width,
               const std::vector<double> &product,
               const NodeSpace           &space,
               const unsigned int         coarse_row,
               BlockRows<double>         &result)
    {
      const unsigned int width    = result.width(coarse_row);
      auto               k        = result.column_begins[coarse_row];
      double            *position = result.panel(coarse_row);
      for (const unsigned int node : pattern.nodes)
        {
          for (; result.columns[k] != space.global(node); ++k)
            position += result.widths[k];
          const double *const factor = product.data() + pattern.offset(node);
          for (unsigned int i = 0; i < space.size(coarse_row); ++i)
            for (unsigned int r = 0; r < height; ++r)
              {
                const double value = part[r * part_stride + i];
                for (unsigned int c = 0; c < result.widths[k]; ++c)
                  position[i * width + c] +=
                    value * factor[r * product_width + c];
              }
        }
    }
  } // namespace



  BlockRows<float>
  smoothed_prolongation(const BlockMatrix<double> &A,
                        const BlockGaussSeidel    &smoother,
                        const BlockRows<double>   &tentative,
                        const NodeSpace           &coarse)
  {
    const double            omega = 4. / 3. / smoother.largest_eigenvalue(A);
    const BlockRows<double> P0    = local_rows(tentative, A.column_space());
    const NodeSpace         space = seen_space(coarse, P0);
    const std::vector<unsigned int> columns = local_columns(P0, space);
    RowPattern                      pattern(space);
    std::vector<double>             values, column(1);
    BlockRows<float>                P;
    for (unsigned int row = 0; row < A.n_rows(); ++row)
      {
        product_row(A, P0, columns, row, pattern, values);
        for (const unsigned int node : pattern.nodes)
          {
            P.columns.push_back(space.global(node));
            P.widths.push_back(space.size(node));
          }
        const unsigned int height = A.height(row);
        P.end_row(height);
        P.allocate();
        const unsigned int width = P.width(row);
        column.resize(height);
        for (unsigned int c = 0; c < width; ++c)
          {
            for (unsigned int r = 0; r < height; ++r)
              column[r] = values[r * width + c];
            smoother.scale(row, height, column.data());
            for (unsigned int r = 0; r < height; ++r)
              values[r * width + c] = -omega * column[r];
          }
        // at most one block
        for (auto l = P0.column_begins[row]; l < P0.column_begins[row + 1]; ++l)
          for (unsigned int r = 0; r < height; ++r)
            for (unsigned int c = 0; c < P0.widths[l]; ++c)
              values[r * width + pattern.offset(columns[l]) + c] +=
                P0.panel(row)[r * P0.widths[l] + c];
        std::copy_n(values.begin(), height * width, P.panel(row));
      }
    P.values.shrink_to_fit();
    return P;
  }



  BlockRows<double>
  galerkin_product(const BlockMatrix<double> &A,
                   const BlockRows<float>    &prolongation,
                   const NodeSpace           &coarse)
  {
    const BlockRows<float> P     = local_rows(prolongation, A.column_space());
    const NodeSpace        space = seen_space(coarse, P);
    const std::vector<unsigned int> columns = local_columns(P, space);
    BlockRows<double>   result = galerkin_pattern(A, P, columns, space);
    RowPattern          pattern(space);
    std::vector<double> product;
    for (unsigned int row = 0; row < A.n_rows(); ++row)
      {
        product_row(A, P, columns, row, pattern, product);
        const unsigned int height = A.height(row);
        const float       *part   = P.panel(row);
        for (auto l = P.column_begins[row]; l < P.column_begins[row + 1]; ++l)
          {
            add_to_row(part,
                       P.width(row),
                       height,
                       pattern,
                       product.size() / height,
                       product,
                       space,
                       columns[l],
                       result);
            part += P.widths[l];
          }
      }
    return sum_to_owners(std::move(result), space);
  }
} // namespace stickslip
