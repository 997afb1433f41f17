// Levels of the multigrid on fewer ranks: nodes keep their numbers, sizes,
// bodies and modes; on any number of ranks the coarsest level is small, ranks
// have a part of a level that is worth a message, and cycles converge as on one
// rank.

#include "lattice.h"
#include "print.h"

#include <stickslip/linear_solvers/multigrid/fewer_ranks.h>
#include <stickslip/linear_solvers/multigrid/read_blocks.h>
#include <stickslip/linear_solvers/multigrid/smoothed_aggregation.h>

#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  unsigned int
  size_of(const NodeSpace::Index node)
  {
    return 1 + node % 6;
  }



  /// What the modes of this test have at an unknown of a node.
  double
  mode(const NodeSpace::Index node, const unsigned int unknown)
  {
    return std::sin(1. + node) + unknown;
  }



  /// Each second rank has nodes, @p n on average, the later ones more.
  void
  test_nodes(const unsigned int n, const unsigned int least)
  {
    print("Nodes of which " + std::to_string(least) +
          " unknowns are to be on a rank, with " + std::to_string(n) +
          " nodes on each second one");
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_owned = rank % 2 == 0 ? n / 2 + n * rank / 16 : 0;
    // sizes depend on the numbers
    const NodeSpace           numbers(std::vector<unsigned int>(n_owned, 1),
                            MPI_COMM_WORLD);
    const auto                first = numbers.first_nodes()[rank];
    std::vector<unsigned int> sizes;
    Modes                     modes;
    modes.n_vectors = 1;
    for (unsigned int k = 0; k < n_owned; ++k)
      {
        sizes.push_back(size_of(first + k));
        modes.nodes.bodies.push_back((first + k) / 5);
        for (unsigned int i = 0; i < sizes.back(); ++i)
          modes.values.push_back(mode(first + k, i));
      }
    NodeSpace  nodes(sizes, MPI_COMM_WORLD);
    const auto n_global         = nodes.n_global(),
               n_unknowns       = nodes.owned_unknowns().size();
    const unsigned int n_owners = nodes.n_owners();
    move_to_fewer_ranks(nodes, modes, least);

    print("all are still there",
          nodes.n_global() == n_global &&
            nodes.owned_unknowns().size() == n_unknowns);
    bool are_the_same = modes.nodes.bodies.size() == nodes.n_owned() &&
                        modes.values.size() == nodes.n_owned_unknowns();
    for (unsigned int node = 0; are_the_same && node < nodes.n_owned(); ++node)
      {
        const auto global = nodes.global(node);
        are_the_same      = nodes.size(node) == size_of(global) &&
                       modes.nodes.bodies[node] == global / 5;
        for (unsigned int i = 0; i < nodes.size(node) && are_the_same; ++i)
          are_the_same = modes.values[nodes.begin(node) + i] == mode(global, i);
      }
    print("numbers mean the same nodes as before", are_the_same);
    const bool         have_moved = nodes.n_owners() < n_owners;
    const unsigned int n_groups =
      std::max((n_owners + 7) / 8,
               static_cast<unsigned int>(n_unknowns / least));
    print("they move if half of the ranks are enough",
          have_moved == (2 * n_groups <= n_owners));
    print("as many have enough, or one of eight has all",
          !have_moved || nodes.n_owners() <= n_groups);
    print("ranks without nodes have none",
          rank % 2 == 0 || nodes.n_owned() == 0);
  }



  /// The hierarchy of a lattice as a preconditioner.
  class Hierarchy
  {
  public:
    explicit Hierarchy(const Lattice &lattice)
      : lattice(lattice)
    {
      const MPI_Comm  communicator = lattice.matrix.get_mpi_communicator();
      const NodeSpace nodes(lattice.owned, 3, communicator);
      levels.reinit(BlockMatrix(read_square_blocks(lattice.matrix, 3),
                                nodes,
                                nodes),
                    {},
                    {},
                    lattice.modes().nodes,
                    lattice.modes());
    }

    void
    vmult(LA::Vector &x, const LA::Vector &b) const
    {
      levels.vmult(x.begin(), b.begin());
    }

    /// Conjugate gradients to 1e-8.
    unsigned int
    n_iterations() const
    {
      const MPI_Comm communicator = lattice.matrix.get_mpi_communicator();
      LA::Vector     x(lattice.owned, communicator), b(x);
      for (const auto i : lattice.owned)
        b(i) = std::sin(1. + 7. * i);
      b.compress(VectorOperation::insert);
      SolverControl        control(200, 1e-8 * b.l2_norm(), false, false);
      SolverCG<LA::Vector> solver(control);
      solver.solve(lattice.matrix, x, b, *this);
      return control.last_step();
    }

    SmoothedAggregation levels;

  private:
    const Lattice &lattice;
  };



  void
  test_hierarchy(const unsigned int n)
  {
    print("Lattice of " + std::to_string(6 * n * n * n) + " unknowns");
    // on rank 0 alone: levels, iterations
    std::vector<unsigned int> alone;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        const Lattice   lattice(n, 1., 1., MPI_COMM_SELF);
        const Hierarchy hierarchy(lattice);
        alone = {hierarchy.levels.n_levels(), hierarchy.n_iterations()};
      }
    alone = Utilities::MPI::broadcast(MPI_COMM_WORLD, alone);

    const Lattice              lattice(n, 1., 1.);
    const Hierarchy            hierarchy(lattice);
    const SmoothedAggregation &levels = hierarchy.levels;
    const unsigned int         last   = levels.n_levels() - 1;
    print("as many levels as on one rank", last + 1 == alone[0]);
    print("all ranks have some of the finest level",
          levels.n_ranks(0) == Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    bool have_enough = true;
    for (unsigned int level = 1; level <= last; ++level)
      have_enough =
        have_enough &&
        (levels.n_ranks(level) <= (levels.n_ranks(level - 1) + 7) / 8 ||
         levels.n_unknowns(level) >= 250 * levels.n_ranks(level));
    print("ranks have 250 unknowns of a coarse level, or one of eight has all",
          have_enough);
    print("the coarsest level has at most 600 unknowns",
          levels.n_unknowns(last) <= 600);
    print("at most two iterations more than on one rank",
          hierarchy.n_iterations() <= alone[1] + 2);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_nodes(100, 10);
  test_nodes(100, 1000);
  test_nodes(100, 100000);
  test_hierarchy(8);
  test_hierarchy(16);
}
