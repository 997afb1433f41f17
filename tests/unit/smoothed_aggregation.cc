// Smoothed aggregation: columns of an aggregate, convergence on elasticity,
// with one body and with two that a thin spring layer couples, the same on any
// number of ranks; the product P^T A P against products with vectors.

#include "lattice.h"
#include "print.h"

#include <stickslip/linear_solvers/multigrid/displacement_multigrid.h>
#include <stickslip/linear_solvers/multigrid/galerkin_product.h>
#include <stickslip/linear_solvers/multigrid/read_blocks.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  unsigned int
  n_cg_iterations(const Lattice &lattice)
  {
    DisplacementMultigrid multigrid;
    multigrid.reinit(lattice.matrix, {}, lattice.description);
    LA::Vector x(lattice.owned, MPI_COMM_WORLD), b(x);
    for (const auto i : lattice.owned)
      b(i) = std::sin(1. + 7. * i);
    b.compress(VectorOperation::insert);
    SolverControl        control(200, 1e-8 * b.l2_norm(), false, false);
    SolverCG<LA::Vector> solver(control);
    solver.solve(lattice.matrix, x, b, multigrid);
    return control.last_step();
  }



  void
  test_convergence()
  {
    print("Conjugate gradients to 1e-8");
    for (const auto &[name, coupling, contrast] :
         {std::make_tuple("one body", 1., 1.),
          std::make_tuple("weakly coupled", 1e-3, 1.),
          std::make_tuple("stiff above", 1., 1e3)})
      {
        const unsigned int coarse =
                             n_cg_iterations(Lattice(6, coupling, contrast)),
                           fine =
                             n_cg_iterations(Lattice(12, coupling, contrast));
        print(std::string(name) +
                ": at most 14 iterations, and at most 4 more "
                "with 8 times as many unknowns",
              fine <= 14 && fine <= coarse + 4);
      }
    for (const auto &[stretch, limit] : {std::make_pair(4., 20u), {8., 30u}})
      print("stretched " + std::to_string(int(stretch)) +
              " times in the plane: at most " + std::to_string(limit) +
              " iterations",
            n_cg_iterations(Lattice(12, 1., 1., MPI_COMM_WORLD, stretch)) <=
              limit);
  }



  /// Largest difference of two vectors' owned parts beside the first one.
  double
  difference(const std::vector<double> &a,
             const std::vector<double> &b,
             const unsigned int         n)
  {
    double largest = 0., scale = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        largest = std::max(largest, std::abs(a[i] - b[i]));
        scale   = std::max(scale, std::abs(a[i]));
      }
    return Utilities::MPI::max(largest, MPI_COMM_WORLD) /
           Utilities::MPI::max(scale, MPI_COMM_WORLD);
  }



  std::vector<double>
  vector_of(const NodeSpace &space)
  {
    std::vector<double> x(space.begin(space.n_local()), 0.);
    for (unsigned int i = 0; i < space.n_owned_unknowns(); ++i)
      x[i] = std::sin(1. + 7. * space.global_unknown(i));
    return x;
  }



  /// The first coarse level of two bodies, which touch or not.
  void
  test_coarse_level(const bool touches)
  {
    print(touches ? "Two bodies that touch" : "Two bodies apart");
    const Lattice    lattice(8, touches ? 1. : 0., 1.);
    const NodeSpace  nodes(lattice.owned, 3, MPI_COMM_WORLD);
    BlockMatrix      A(read_square_blocks(lattice.matrix, 3), nodes, nodes);
    const NodeSpace &space = A.column_space();

    const Modes modes = lattice.modes();
    const auto  aggregates =
      find_aggregates(A, single_nodes(A.n_rows()), modes.nodes);
    const auto tentative = tentative_prolongation(space, aggregates, modes);

    bool all_are_in = true, is_in_one_body = true;
    for (unsigned int node = 0; node < space.n_owned(); ++node)
      {
        const unsigned int height    = lattice.height(space.global(node)),
                           aggregate = aggregates.of_node[node];
        all_are_in =
          all_are_in && (aggregate == Aggregates::none) == (height == 0);
        is_in_one_body =
          is_in_one_body &&
          (height == 0 || tentative.coarse_modes.nodes.bodies[aggregate] ==
                            lattice.body(space.global(node)));
      }
    bool has_six_columns = true;
    for (unsigned int a = 0; a < aggregates.n; ++a)
      has_six_columns = has_six_columns && tentative.coarse.size(a) == 6;
    print("all nodes that are free are in aggregates",
          Utilities::MPI::min(all_are_in ? 1 : 0, MPI_COMM_WORLD) == 1);
    print("each aggregate is in one body",
          Utilities::MPI::min(is_in_one_body ? 1 : 0, MPI_COMM_WORLD) == 1);
    print("aggregates have six columns",
          Utilities::MPI::min(has_six_columns ? 1 : 0, MPI_COMM_WORLD) == 1);

    BlockMatrix P0(BlockRows<double>(tentative.rows), space, tentative.coarse);
    double      error = 0.;
    for (unsigned int m = 0; m < modes.n_vectors; ++m)
      {
        std::vector<double> coarse, fine(space.n_owned_unknowns(), 0.), exact;
        for (unsigned int i = 0; i < tentative.coarse.n_owned_unknowns(); ++i)
          coarse.push_back(
            tentative.coarse_modes.values[i * modes.n_vectors + m]);
        P0.vmult_add(fine, coarse);
        for (unsigned int i = 0; i < fine.size(); ++i)
          exact.push_back(modes.values[i * modes.n_vectors + m]);
        error = std::max(error, difference(exact, fine, fine.size()));
      }
    print("all modes are represented", error < 1e-12);

    BlockGaussSeidel smoother;
    smoother.reinit(A, single_nodes(A.n_rows()));
    auto P_rows =
      smoothed_prolongation(A, smoother, tentative.rows, tentative.coarse);
    const BlockMatrix  product(galerkin_product(A, P_rows, tentative.coarse),
                              tentative.coarse,
                              tentative.coarse);
    const Prolongation P(std::move(P_rows), space, tentative.coarse);
    const unsigned int n = tentative.coarse.n_owned_unknowns();

    std::vector<double> x = vector_of(product.column_space()), y(n, 0.);
    product.column_space().update_ghosts(x);
    product.vmult_add(y, x);
    std::vector<double> coarse = vector_of(P.coarse_space());
    std::vector<double> fine(space.begin(space.n_local()), 0.),
      forces(space.n_owned_unknowns(), 0.), restricted;
    P.add_to_fine(fine, coarse);
    space.update_ghosts(fine);
    A.vmult_add(forces, fine);
    P.restrict_to_coarse(restricted, forces);
    print("P^T A P is that of products with vectors",
          difference(restricted, y, n) < 1e-12);
  }



  /// A matrix without a third of the blocks of another one's lower half.
  BlockRows<double>
  one_sided(const BlockRows<double> &rows, const NodeSpace &nodes)
  {
    BlockRows<double> result;
    for (unsigned int row = 0; row < rows.n_rows(); ++row)
      {
        const auto         global  = nodes.global(row);
        const unsigned int width   = rows.width(row);
        const auto         is_kept = [&](const std::size_t k) {
          return rows.columns[k] >= global ||
                 (rows.columns[k] + global) % 3 > 0;
        };
        for (auto k = rows.column_begins[row]; k < rows.column_begins[row + 1];
             ++k)
          if (is_kept(k))
            {
              result.columns.push_back(rows.columns[k]);
              result.widths.push_back(rows.widths[k]);
            }
        result.end_row(3);
        result.allocate();
        double *target = result.panel(row);
        for (unsigned int r = 0; r < 3; ++r)
          for (auto k = rows.column_begins[row];
               k < rows.column_begins[row + 1];
               ++k)
            if (is_kept(k))
              target = std::copy_n(rows.panel(row) + r * width +
                                     3 * (k - rows.column_begins[row]),
                                   3,
                                   target);
      }
    return result;
  }



  /**
   * Symmetric Gauss-Seidel sweeps M over all ranks: M^-1 A has no eigenvalue
   * above 1 (with sweeps of each rank for itself it has).
   */
  void
  test_sweeps(const bool is_symmetric)
  {
    print(is_symmetric ? "Sweeps" : "Sweeps with one-sided neighbours");
    const Lattice   lattice(8, 1., 1.);
    const NodeSpace nodes(lattice.owned, 3, MPI_COMM_WORLD);
    auto            rows = read_square_blocks(lattice.matrix, 3);
    if (!is_symmetric)
      rows = one_sided(rows, nodes);
    // entries that single precision has, so that sweeps are those of A
    for (double &value : rows.values)
      value = float(value);
    BlockMatrix      A(std::move(rows), nodes, nodes);
    BlockGaussSeidel smoother;
    smoother.reinit(A, single_nodes(A.n_rows()));
    const NodeSpace    &space = A.column_space();
    const unsigned int  n     = space.n_owned_unknowns();
    std::vector<double> u, residual, again(n), b = vector_of(space);
    smoother.solve(u, residual, b);
    u.resize(space.begin(space.n_local()));
    space.update_ghosts(u);
    A.vmult_add(again, u);
    for (unsigned int i = 0; i < n; ++i)
      again[i] = b[i] - again[i];
    print("leave the residual that they say",
          difference(again, residual, n) < 1e-12);

    std::vector<double> from_zero = u;
    std::fill(u.begin(), u.end(), 0.);
    smoother.smooth(u, b);
    print("are the same from zero as from a given zero",
          difference(from_zero, u, n) < 1e-12);
    if (!is_symmetric)
      return;

    double eigenvalue = 0.;
    for (unsigned int step = 0; step < 200; ++step)
      {
        space.update_ghosts(u);
        std::fill(b.begin(), b.end(), 0.);
        A.vmult_add(b, u);
        smoother.solve(u, residual, b);
        double square = 0.;
        for (unsigned int i = 0; i < n; ++i)
          square += u[i] * u[i];
        eigenvalue = std::sqrt(Utilities::MPI::sum(square, MPI_COMM_WORLD));
        for (double &value : u)
          value /= eigenvalue;
      }
    print("have no eigenvalue above 1", eigenvalue < 1. + 1e-8);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_coarse_level(false);
  test_coarse_level(true);
  test_sweeps(true);
  test_sweeps(false);
  test_convergence();
}
