// What block AMG is made of: rigid modes of coloured bodies, the linear space
// below elements of degree 2, the augmented matrix and the contact interface;
// on a tower of three blocks, separated by gaps or closed.

#include "case_problem.h"
#include "print.h"

#include <stickslip/linear_solvers/block_amg_solver.h>
#include <stickslip/linear_solvers/multigrid/block_matrix.h>

#include <stickslip/problem/rigid_modes.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace stickslip;

namespace
{
  std::string
  block(const std::string &name,
        const int          dim,
        const int          n,
        const double       height)
  {
    const std::string N = std::to_string(n), z = std::to_string(height),
                      top = std::to_string(height + 1.);
    return "subsection " + name +
           "\nset Generator = subdivided_hyper_rectangle\nset Arguments = " +
           (dim == 2 ? N + "," + N + ": 0," + z + ": 1," + top + ": true"
                     : N + "," + N + "," + N + ": 0,0," + z + ": 1,1," + top +
                         ": true") +
           "\nset Material = m\nend\n";
  }



  /// Lower, middle and upper block; the lower one is held at its bottom.
  std::string
  tower(const int dim, const int degree, const double gap)
  {
    const std::string low = std::to_string(2 * dim - 2),
                      top = std::to_string(2 * dim - 1);
    const auto contact    = [&](const std::string &slave,
                             const std::string &master) {
      return "subsection " + slave + " on " + master +
             "\nset Slave body = " + slave + "\nset Slave boundary = " + low +
             "\nset Master body = " + master +
             "\nset Master boundary = " + top +
             "\nset Friction = Tresca\nset Tresca threshold = 1e-3\nend\n";
    };
    return "set Dimension = " + std::to_string(dim) +
           "\nset Degree = " + std::to_string(degree) +
           "\nsubsection Bodies\n" + block("lower", dim, 3, 0.) +
           block("middle", dim, 2, 1. + gap) +
           block("upper", dim, 3, 2. + 2. * gap) +
           "end\nsubsection Materials\nsubsection m\nset Law = linear elastic\n"
           "set Young's modulus = 1\nset Poisson's ratio = 0.3\nend\nend\n"
           "subsection Boundary conditions\nsubsection bottom\nset Body = "
           "lower\n"
           "set Boundary = " +
           low + "\nset Value = " + (dim == 2 ? "0; 0" : "0; 0; 0") +
           "\nend\nend\nsubsection Contact\n" + contact("middle", "lower") +
           contact("upper", "middle") + "end\n";
  }



  constexpr unsigned int all_bodies = -1;

  /// A mode of one body or of all.
  LA::Vector
  mode(const NearNullSpace &space,
       const unsigned int   m,
       const unsigned int   body,
       const IndexSet      &owned)
  {
    LA::Vector   vector(owned, MPI_COMM_WORLD);
    unsigned int row = 0;
    for (const auto i : owned)
      {
        if (body == all_bodies ||
            body == space.nodes.bodies[row * space.nodes.bodies.size() /
                                       owned.n_elements()])
          vector(i) = space.values[m * owned.n_elements() + row];
        ++row;
      }
    vector.compress(VectorOperation::insert);
    return vector;
  }



  /// Any vector that is the same on all numbers of ranks.
  void
  fill(LA::Vector &vector)
  {
    for (const auto i : vector.locally_owned_elements())
      vector(i) = std::sin(1. + 7. * i);
    vector.compress(VectorOperation::insert);
  }



  template <int dim>
  struct Tower : CaseProblem<dim>
  {
    using CaseProblem<dim>::problem;

    Tower(const int degree, const double gap)
      : CaseProblem<dim>(tower(dim, degree, gap))
    {
      const auto x = problem.zero_state();
      problem.begin_step(1., x);
      problem.begin_iteration(x);
      problem.residual(x);
      problem.assemble(x);
    }
  };



  /// With gaps the bodies are free, so that the rigid motions of the middle one
  /// are a null space.
  template <int dim>
  void
  test_modes(const int degree)
  {
    Tower<dim>  tower(degree, 0.25);
    auto       &problem = tower.problem;
    const auto &system  = problem.describe_system();
    const auto &space   = *system.near_null_space;
    const auto &A       = problem.matrix().block(0, 0);
    print("  " + std::to_string(space.n_vectors) + " vectors");
    const IndexSet rows =
      system.prolongation ? system.prolongation->locally_owned_domain_indices()
                          : problem.layout().owned;
    double     largest = 0., smallest_held = 1e300, smallest_mode = 1e300;
    LA::Vector u(problem.layout().owned, MPI_COMM_WORLD), forces(u);
    for (unsigned int m = 0; m < space.n_vectors; ++m)
      {
        const auto move = [&](const unsigned int body) {
          const LA::Vector z = mode(space, m, body, rows);
          if (system.prolongation)
            system.prolongation->vmult(u, z);
          else
            u = z;
          A.vmult(forces, u);
          smallest_mode = std::min(smallest_mode, u.linfty_norm());
          return forces.linfty_norm();
        };
        smallest_held = std::min(smallest_held, move(all_bodies));
        largest       = std::max(largest, move(1));
      }
    print("  rigid motions of the middle body are in the null space",
          largest < 1e-12);
    print("  motions of all bodies are not, where one is held",
          smallest_held > 1e-3);
    // the least is the rotation about the axis of the slender tower: half its
    // width over half its diagonal, 0.26
    print("  all modes move nodes", smallest_mode > 0.25);
  }



  /// Closed contact: the augmented matrix and the interface.
  template <int dim>
  void
  test_interface(const int degree)
  {
    // without an overlap roundoff decides what is closed
    Tower<dim>  tower(degree, -1e-6);
    auto       &problem = tower.problem;
    const auto &K       = problem.matrix();
    const auto &system  = problem.describe_system();

    InterfaceAugmentation augmentation;
    augmentation.reinit(K, system, 4.);
    const NodeSpace   nodes(problem.layout().owned,
                          system.n_components,
                          MPI_COMM_WORLD);
    const BlockMatrix added(augmentation.added_blocks(system.n_components),
                            nodes,
                            nodes);
    LA::BlockVector   x = problem.zero_state(), product(x), residual(x);
    fill(x.block(0));
    fill(x.block(1));
    K.block(0, 0).vmult(product.block(0), x.block(0));
    const double before = product.block(0).l2_norm();
    K.block(1, 0).vmult(product.block(1), x.block(0));
    OwnedEntries entries = owned_entries(product);
    augmentation.add_to(entries);
    set_owned_entries(product, entries);
    K.block(0, 0).vmult(residual.block(0), x.block(0));
    std::vector<double> sum = owned_entries(residual), u = owned_entries(x);
    sum.resize(nodes.n_owned_unknowns());
    u.resize(added.column_space().begin(added.column_space().n_local()));
    added.column_space().update_ghosts(u);
    added.vmult_add(sum, u);
    std::copy(sum.begin(), sum.end(), residual.block(0).begin());
    residual.block(0) -= product.block(0);
    print("  rows are added as the augmented matrix has them",
          residual.block(0).l2_norm() < 1e-12 * before);
    residual.block(0) = product.block(0);
    K.block(0, 0).vmult(product.block(0), x.block(0));
    residual.block(0) -= product.block(0);
    print("  the augmentation is of the size of the stiffness",
          residual.block(0).l2_norm() > 0.1 * before &&
            residual.block(0).l2_norm() < 100. * before);

    InterfaceSolver interface(100000);
    interface.determine_unknowns(K, true);
    interface.factorise(K);
    print(
      "  unknowns of the interface: " + std::to_string(interface.n_unknowns()) +
      " of " + std::to_string(K.m()));
    LA::BlockVector correction = problem.zero_state();
    OwnedEntries    solution(entries.size(), 0.);
    interface.solve(solution, owned_entries(x));
    set_owned_entries(correction, solution);
    BlockProduct rows;
    rows.reinit(K);
    rows.set_part(interface.marks(solution.size()));
    OwnedEntries of_part(solution.size(), 0.);
    rows.add_part(of_part, solution);
    K.vmult(residual, correction);
    LA::BlockVector missing = residual;
    set_owned_entries(missing, of_part);
    missing -= residual;
    print("  the rows that see the interface are all that move",
          missing.linfty_norm() <= 1e-14 * residual.linfty_norm());
    residual -= x;
    double left = residual.block(1).linfty_norm();
    for (const auto i : residual.block(0).locally_owned_elements())
      if (LA::row_length(K.block(0, 1), i) > 0)
        left = std::max(left, std::abs(residual.block(0)(i)));
    // weakly held bodies move far: what is left is compared with what cancels
    const double forces =
      K.block(0, 0).linfty_norm() * correction.linfty_norm();
    print("  nothing is left of the residual there",
          Utilities::MPI::max(left, MPI_COMM_WORLD) < 1e-15 * forces);

    // with the stiffness of the nodes alone, in the pattern of all and in its
    // own, which is too small for all
    LA::BlockSparseMatrix uncoupled;
    uncoupled.reinit(2, 2);
    for (unsigned int a = 0; a < 2; ++a)
      for (unsigned int b = 0; b < 2; ++b)
        uncoupled.block(a, b).copy_from(K.block(a, b));
    uncoupled.collect_sizes();
    uncoupled.block(0, 0) = 0.;
    for (const auto i : K.block(0, 0).locally_owned_range_indices())
      uncoupled.block(0, 0).set(i, i, K.block(0, 0).diag_element(i));
    uncoupled.compress(VectorOperation::insert);
    const auto solve = [&](InterfaceSolver             &solver,
                           const LA::BlockSparseMatrix &matrix) {
      solver.factorise(matrix);
      OwnedEntries u(entries.size(), 0.);
      solver.solve(u, owned_entries(x));
      return u;
    };
    const auto largest = [](const OwnedEntries &u, const OwnedEntries &v) {
      double difference = 0.;
      for (unsigned int i = 0; i < u.size(); ++i)
        difference = std::max(difference, std::abs(u[i] - v[i]));
      return Utilities::MPI::max(difference, MPI_COMM_WORLD);
    };
    InterfaceSolver another(100000);
    another.determine_unknowns(K, true);
    const OwnedEntries zero(entries.size(), 0.);
    const OwnedEntries in_pattern_of_all = solve(interface, uncoupled);
    const OwnedEntries in_own_pattern    = solve(another, uncoupled);
    print("  zeros in the pattern change nothing",
          largest(in_pattern_of_all, in_own_pattern) <
            1e-8 * largest(in_own_pattern, zero));
    print("  a pattern without all entries is not kept",
          largest(solve(another, K), solution) <
            1e-6 * largest(solution, zero));
  }



  /// Open contact: no displacement is in the interface, unless its multipliers
  /// count as acting.
  template <int dim>
  void
  test_open_interface(const int degree)
  {
    Tower<dim>      tower(degree, 0.25);
    const auto     &K = tower.problem.matrix();
    LA::Vector      all(tower.problem.zero_state().block(1));
    InterfaceSolver interface(100000);
    const bool      is_new = interface.determine_unknowns(K, true);
    interface.factorise(K);
    print("  unknowns of the interface of open contact: " +
          std::to_string(interface.n_unknowns()) + " of " +
          std::to_string(K.m()) +
          ", multipliers: " + std::to_string(K.block(1, 1).m()));
    const bool is_same = !interface.determine_unknowns(K, false);
    all                = 1.;
    const bool grows   = interface.determine_unknowns(K, false, &all);
    interface.factorise(K);
    print("  with multipliers that count as acting: " +
          std::to_string(interface.n_unknowns()));
    LA::Vector one(all);
    one = 0.;
    if (one.locally_owned_elements().is_element(0))
      one(0) = 1.;
    one.compress(VectorOperation::insert);
    const bool shrinks = interface.determine_unknowns(K, false, &one);
    interface.factorise(K);
    print("  with one of them: " + std::to_string(interface.n_unknowns()));
    print("  it tells when it is another one",
          is_new && is_same && grows && shrinks);
  }



  template <int dim>
  void
  test(const int degree)
  {
    print(std::to_string(dim) + "D, degree " + std::to_string(degree));
    test_modes<dim>(degree);
    test_interface<dim>(degree);
    test_open_interface<dim>(degree);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(1);
  test<2>(2);
  test<3>(1);
  test<3>(2);
}
