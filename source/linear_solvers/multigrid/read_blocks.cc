#include <stickslip/linear_solvers/multigrid/read_blocks.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;

    /// The columns that owned rows of a matrix have, as parts of nodes of
    /// @p width unknowns.
    class ColumnNodes
    {
    public:
      /// With the nodes @p others, which the matrix may lack.
      ColumnNodes(const LA::SparseMatrix &matrix,
                  const unsigned int      width,
                  std::vector<Index>      others)
        : nodes(std::move(others))
      {
        const auto columns = LA::column_numbers(matrix);
        for (const Index column : columns)
          nodes.push_back(column / width);
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        for (const Index column : columns)
          parts.push_back(
            {place(column / width), static_cast<unsigned int>(column % width)});
      }

      struct Part
      {
        unsigned int place; ///< of the node
        unsigned int component;
      };

      /// What a local column is.
      Part
      operator[](const unsigned int column) const
      {
        return parts[column];
      }

      unsigned int
      place(const Index node) const
      {
        return std::lower_bound(nodes.begin(), nodes.end(), node) -
               nodes.begin();
      }

      std::vector<Index> nodes; ///< by place, ascending

    private:
      std::vector<Part> parts;
    };



    /// Blocks that may differ from zero, at most.
    std::size_t
    count_blocks(const LA::SparseMatrix  &matrix,
                 const unsigned int       height,
                 const ColumnNodes       &seen,
                 const BlockRows<double> &added)
    {
      const IndexSet            owned = matrix.locally_owned_range_indices();
      std::vector<unsigned int> last(seen.nodes.size(),
                                     numbers::invalid_unsigned_int);
      std::size_t               n = owned.n_elements() + added.columns.size();
      for (const auto row : owned)
        LA::visit_local_row(matrix,
                            row,
                            [&](const unsigned int column, const double) {
                              unsigned int &row_before =
                                last[seen[column].place];
                              n += row_before != row / height;
                              row_before = row / height;
                            });
      return n;
    }



    /// A row of blocks, height times width each, that is summed up.
    class RowSum
    {
    public:
      RowSum(const unsigned int n_places,
             const unsigned int height,
             const unsigned int width)
        : height(height)
        , width(width)
        , blocks(n_places, numbers::invalid_unsigned_int)
      {}

      /// The entries of the block of a node, row by row.
      double *
      block(const unsigned int place)
      {
        if (blocks[place] == numbers::invalid_unsigned_int)
          {
            blocks[place] = places.size();
            places.push_back(place);
            entries.resize(places.size() * height * width, 0.);
          }
        return entries.data() + blocks[place] * height * width;
      }

      /// Appends the sum to @p rows and begins a new one.
      template <typename Number>
      void
      move_to(BlockRows<Number> &rows, const std::vector<Index> &nodes)
      {
        std::sort(places.begin(), places.end());
        for (const unsigned int place : places)
          {
            rows.columns.push_back(nodes[place]);
            rows.widths.push_back(width);
          }
        rows.end_row(height);
        rows.allocate();
        Number *value = rows.panel(rows.n_rows() - 1);
        for (unsigned int r = 0; r < height; ++r)
          for (const unsigned int place : places)
            {
              const double *const part =
                entries.data() + (blocks[place] * height + r) * width;
              for (unsigned int c = 0; c < width; ++c)
                *value++ = part[c];
            }
        for (const unsigned int place : places)
          blocks[place] = numbers::invalid_unsigned_int;
        places.clear();
        entries.clear();
      }

    private:
      const unsigned int        height, width;
      std::vector<unsigned int> places; ///< in the order of their blocks
      std::vector<unsigned int> blocks; ///< by place
      std::vector<double>       entries;
    };



    void
    add_row(const BlockRows<double> &added,
            const unsigned int       row,
            const unsigned int       height,
            const ColumnNodes       &seen,
            RowSum                  &sum)
    {
      const double      *entries = added.panel(row);
      const unsigned int stride  = added.width(row);
      for (auto k = added.column_begins[row]; k < added.column_begins[row + 1];
           ++k)
        {
          const unsigned int width = added.widths[k];
          add_block(entries,
                    stride,
                    height,
                    width,
                    sum.block(seen.place(added.columns[k])),
                    width);
          entries += width;
        }
    }



    /// @p diagonals: nodes of the rows, the diagonal blocks of which are there
    /// even if they are zero.
    template <typename Number>
    BlockRows<Number>
    read(const LA::SparseMatrix   &matrix,
         const unsigned int        height,
         const unsigned int        width,
         const std::vector<Index> &diagonals,
         const BlockRows<double>  &added)
    {
      std::vector<Index> others(diagonals);
      others.insert(others.end(), added.columns.begin(), added.columns.end());
      const ColumnNodes seen(matrix, width, std::move(others));
      const IndexSet    owned = matrix.locally_owned_range_indices();
      const Index       first = owned.is_empty() ? 0 : *owned.begin();
      RowSum            sum(seen.nodes.size(), height, width);
      BlockRows<Number> rows;
      rows.values.reserve(count_blocks(matrix, height, seen, added) * height *
                          width);
      for (unsigned int row = 0; row < owned.n_elements() / height; ++row)
        {
          if (!diagonals.empty())
            sum.block(seen.place(diagonals[row]));
          for (unsigned int r = 0; r < height; ++r)
            LA::visit_local_row(
              matrix,
              first + row * height + r,
              [&](const unsigned int column, const double value) {
                if (value != 0.)
                  {
                    const auto part = seen[column];
                    sum.block(part.place)[r * width + part.component] += value;
                  }
              });
          if (added.n_rows() > 0)
            add_row(added, row, height, seen, sum);
          sum.move_to(rows, seen.nodes);
        }
      return rows;
    }
  } // namespace



  template <typename Number>
  BlockRows<Number>
  read_blocks(const LA::SparseMatrix &matrix,
              const unsigned int      height,
              const unsigned int      width)
  {
    return read<Number>(matrix, height, width, {}, {});
  }



  BlockRows<double>
  read_square_blocks(const LA::SparseMatrix  &matrix,
                     const unsigned int       n,
                     const BlockRows<double> &added)
  {
    std::vector<Index> nodes;
    const IndexSet     owned = matrix.locally_owned_range_indices();
    for (const Index row : owned)
      if (row % n == 0)
        nodes.push_back(row / n);
    return read<double>(matrix, n, n, nodes, added);
  }



  template BlockRows<float>
  read_blocks(const LA::SparseMatrix &, const unsigned int, const unsigned int);
  template BlockRows<double>
  read_blocks(const LA::SparseMatrix &, const unsigned int, const unsigned int);
} // namespace stickslip
