#include <stickslip/base/no_convergence.h>
#include <stickslip/base/short_message.h>

#include <stickslip/linear_solvers/displacement_multigrid.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;



    /// Nodes of @p n_components consecutive unknowns.
    NodeSpace
    nodes_of(const IndexSet    &unknowns,
             const unsigned int n_components,
             const MPI_Comm    &communicator)
    {
      AssertThrow(unknowns.n_elements() % n_components == 0,
                  ExcMessage("A node is on two ranks."));
      return NodeSpace(std::vector<unsigned int>(unknowns.n_elements() /
                                                   n_components,
                                                 n_components),
                       communicator);
    }



    /**
     * The sum of @p matrices in blocks of @p n unknowns, without blocks that
     * are zero, except those on the diagonal if @p is_square. All matrices
     * have the same rows.
     */
    template <typename Number>
    BlockRows<Number>
    block_rows(const std::vector<const LA::SparseMatrix *> &matrices,
               const unsigned int                           n,
               const bool                                   is_square)
    {
      const IndexSet owned = matrices.front()->locally_owned_range_indices();
      // calls act(row in the block, column, value) for entries from @p first on
      const auto visit_block = [&](const Index first, const auto &act) {
        for (const auto *matrix : matrices)
          for (unsigned int r = 0; r < n; ++r)
            LA::visit_row(*matrix,
                          first + r,
                          [&](const Index column, const double value) {
                            if (value != 0.)
                              act(r, column, value);
                          });
      };
      BlockRows<Number>  rows;
      std::vector<Index> nodes;
      for (auto row = owned.begin(); row != owned.end(); std::advance(row, n))
        {
          nodes.assign(is_square ? 1 : 0, *row / n);
          visit_block(*row, [&](const auto, const Index column, const auto) {
            if (nodes.empty() || nodes.back() != column / n)
              nodes.push_back(column / n);
          });
          std::sort(nodes.begin(), nodes.end());
          nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
          rows.columns.insert(rows.columns.end(), nodes.begin(), nodes.end());
          rows.widths.resize(rows.columns.size(), n);
          rows.end_row(n);
        }
      rows.allocate();
      unsigned int block = 0;
      for (auto row = owned.begin(); row != owned.end();
           std::advance(row, n), ++block)
        {
          const Index *const begin =
            rows.columns.data() + rows.column_begins[block];
          const Index *const end =
            rows.columns.data() + rows.column_begins[block + 1];
          const Index       *k     = begin; // most often the next one is there
          const unsigned int width = n * (end - begin);
          visit_block(
            *row,
            [&](const unsigned int r, const Index column, const double value) {
              if (*k != column / n)
                k = std::lower_bound(begin, end, column / n);
              rows.panel(block)[r * width + (k - begin) * n + column % n] +=
                value;
            });
        }
      return rows;
    }



    Modes
    modes_of(const NearNullSpace &space, const unsigned int n_unknowns)
    {
      Modes modes;
      modes.n_vectors = space.n_vectors;
      modes.values.resize(space.values.size());
      for (unsigned int v = 0; v < space.n_vectors; ++v)
        for (unsigned int i = 0; i < n_unknowns; ++i)
          modes.values[i * space.n_vectors + v] =
            space.values[v * n_unknowns + i];
      return modes;
    }
  } // namespace



  void
  DisplacementMultigrid::reinit(const LA::SparseMatrix       &matrix,
                                const LA::SparseMatrix       &added,
                                const BlockSystemDescription &description)
  {
    const MPI_Comm     communicator = matrix.get_mpi_communicator();
    const unsigned int n            = description.n_components;
    clear();
    try
      {
        const NodeSpace nodes =
          nodes_of(matrix.locally_owned_range_indices(), n, communicator);
        NodeSpace        linear_nodes;
        BlockRows<float> prolongation;
        if (description.prolongation)
          {
            linear_nodes =
              nodes_of(description.prolongation->locally_owned_domain_indices(),
                       n,
                       communicator);
            prolongation =
              block_rows<float>({description.prolongation.get()}, n, false);
          }
        std::vector<const LA::SparseMatrix *> parts(1, &matrix);
        if (added.m() > 0)
          parts.push_back(&added);
        hierarchy.reinit(
          BlockMatrix<double>(block_rows<double>(parts, n, true), nodes, nodes),
          std::move(prolongation),
          linear_nodes,
          modes_of(*description.near_null_space,
                   description.prolongation ? linear_nodes.n_owned_unknowns()
                                            : nodes.n_owned_unknowns()));
      }
    catch (const std::exception &error)
      {
        throw NoConvergence("Linear solver (block AMG)",
                            "no multigrid hierarchy of this matrix: " +
                              short_message(error),
                            FailureCause::linear_solver);
      }
  }
} // namespace stickslip
