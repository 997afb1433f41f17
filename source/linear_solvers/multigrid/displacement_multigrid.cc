#include <stickslip/linear_solvers/multigrid/displacement_multigrid.h>

#include <stickslip/base/no_convergence.h>
#include <stickslip/base/short_message.h>

#include <stickslip/linear_solvers/multigrid/read_blocks.h>

#include <exception>
#include <utility>
#include <vector>


namespace stickslip
{
  namespace
  {
    Modes
    modes_of(const NearNullSpace &space, const unsigned int n_unknowns)
    {
      Modes modes;
      modes.n_vectors = space.n_vectors;
      modes.nodes     = space.nodes;
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
                                const BlockRows<double>      &added,
                                const BlockSystemDescription &description)
  {
    const MPI_Comm     communicator = matrix.get_mpi_communicator();
    const unsigned int n            = description.n_components;
    clear();
    try
      {
        const NodeSpace  nodes(matrix.locally_owned_range_indices(),
                              n,
                              communicator);
        NodeSpace        linear_nodes;
        BlockRows<float> prolongation;
        if (description.prolongation)
          {
            linear_nodes = NodeSpace(
              description.prolongation->locally_owned_domain_indices(),
              n,
              communicator);
            prolongation = read_blocks<float>(*description.prolongation, n, n);
          }
        const unsigned int n_unknowns = description.prolongation
                                          ? linear_nodes.n_owned_unknowns()
                                          : nodes.n_owned_unknowns();
        hierarchy.reinit(
          BlockMatrix(read_square_blocks(matrix, n, added), nodes, nodes),
          std::move(prolongation),
          std::move(linear_nodes),
          description.prolongation ? description.nodes
                                   : description.near_null_space->nodes,
          modes_of(*description.near_null_space, n_unknowns));
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
