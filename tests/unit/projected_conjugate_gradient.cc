// The projected conjugate gradient on a chain of springs whose nodes carry
// contact with friction: equilibrium, complementarity and the projection
// property of the multipliers it finds, from different starts.

#include <stickslip/linear_solvers/projected_conjugate_gradient.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace stickslip;

namespace
{
  constexpr unsigned int n_nodes =
    8; ///< two displacements and multipliers each

  struct Chain
  {
    LA::BlockSparseMatrix matrix;
    LA::BlockVector       rhs;
    LA::Vector            diagonal;
    AdmissibleMultipliers admissible;

    Chain()
    {
      const IndexSet              owned  = complete_index_set(2 * n_nodes);
      const std::vector<IndexSet> blocks = {owned, owned};
      LA::BlockSparsityPattern    pattern(blocks, MPI_COMM_SELF);
      for (unsigned int i = 0; i < 2 * n_nodes; ++i)
        {
          for (unsigned int j = 0; j < 2 * n_nodes; ++j)
            pattern.block(0, 0).add(i, j);
          pattern.block(0, 1).add(i, i);
          pattern.block(1, 0).add(i, i);
          pattern.block(1, 1).add(i, i);
        }
      pattern.compress();
      matrix.reinit(pattern);
      rhs.reinit(blocks, MPI_COMM_SELF);
      diagonal.reinit(owned, MPI_COMM_SELF);
      for (unsigned int node = 0; node < n_nodes; ++node)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const unsigned int i = 2 * node + c;
            matrix.block(0, 0).set(i, i, 2.5);
            if (node + 1 < n_nodes)
              {
                matrix.block(0, 0).set(i, i + 2, -1.);
                matrix.block(0, 0).set(i + 2, i, -1.);
              }
            // rows as contact makes them: minus the gap, s times the slip
            const bool   is_free = node == 3; // a node without contact
            const double entry   = is_free  ? 0.
                                   : c == 0 ? -0.7
                                            : 0.3 + 0.1 * node;
            matrix.block(0, 1).set(i, i, entry);
            matrix.block(1, 0).set(i, i, entry);
            diagonal(i)     = entry * entry / 2.5;
            rhs.block(0)(i) = c == 0 ? 1.5 - 0.5 * node : 1.2 - 0.25 * node;
            rhs.block(1)(i) = c == 0 ? -0.05 * node : 0.;
          }
      matrix.compress(VectorOperation::insert);
      rhs.compress(VectorOperation::insert);
      diagonal.compress(VectorOperation::insert);
      for (unsigned int node = 0; node < n_nodes; ++node)
        admissible.nodes.push_back({2 * node, 2, node != 3, node != 5});
    }
  };



  double
  solve(const Chain &chain, const double start, LA::BlockVector &increment)
  {
    LA::Vector y0(chain.rhs.block(1));
    y0 = start;
    increment.reinit(chain.rhs);
    ProjectedConjugateGradient(1e-13, 200)
      .solve(chain.matrix,
             chain.rhs,
             chain.diagonal,
             chain.admissible,
             y0,
             increment);
    LA::Vector y(y0);
    y += increment.block(1);

    // K du + B^T (y - y0) = r_u
    LA::Vector force(chain.rhs.block(0)), part(force);
    chain.matrix.block(0, 0).vmult(force, increment.block(0));
    chain.matrix.block(0, 1).vmult(part, increment.block(1));
    force += part;
    force -= chain.rhs.block(0);
    double worst = force.linfty_norm();

    // y = P(y + gap) for the gap in any unit
    LA::Vector gap(y);
    chain.matrix.block(1, 0).vmult(gap, increment.block(0));
    gap -= chain.rhs.block(1);
    for (const double scale : {0.1, 10.})
      {
        LA::Vector moved(y);
        moved.add(scale, gap);
        chain.admissible.project(moved);
        moved -= y;
        worst = std::max(worst, moved.linfty_norm());
      }
    increment.block(1) = y;
    return worst;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Chain                      chain;
  LA::BlockVector                  result, other;
  const double                     error = solve(chain, 0., result);
  std::cout << "equilibrium and projection below 1e-11: "
            << (error < 1e-11 ? "yes" : "NO") << '\n'
            << "node: lambda_n, Lambda\n";
  for (unsigned int node = 0; node < n_nodes; ++node)
    std::cout << node << ": " << result.block(1)(2 * node) + 0. << ", "
              << result.block(1)(2 * node + 1) + 0. << '\n';
  // far from the solution and not admissible: the forces of the start are in
  // the residual then
  Chain      shifted;
  LA::Vector start(chain.rhs.block(1)), force(chain.rhs.block(0));
  start = 2.;
  chain.matrix.block(0, 1).vmult(force, start);
  shifted.rhs.block(0) -= force;
  solve(shifted, 2., other);
  other.block(1) -= result.block(1);
  std::cout << "the same from another start to 1e-11: "
            << (other.block(1).linfty_norm() < 1e-11 ? "yes" : "NO") << '\n';
}
