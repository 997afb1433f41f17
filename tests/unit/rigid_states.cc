// Rotations in space, the rigid motion closest to displacements, and which
// displacements stand for the free components of a motion.

#include "print.h"

#include <stickslip/solid/coupling_masters.h>
#include <stickslip/solid/finite_rotation.h>
#include <stickslip/solid/rigid_state.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/numbers.h>

#include <cmath>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  const Tensor<1, 3> some_vector({0.7, -1.9, 1.3});



  double
  relative_error(const Tensor<1, 3> &value, const Tensor<1, 3> &expected)
  {
    return (value - expected).norm() / expected.norm();
  }



  void
  test_rotations()
  {
    bool agree = true, keeps_length = true, composes = true;
    for (const double angle : {1e-12, 1e-5, 0.3, 2., 3.141})
      {
        const Tensor<1, 3> theta = angle / some_vector.norm() * some_vector;
        const auto         R     = FiniteRotation::from_vector(theta);
        agree = agree && relative_error(R.vector(), theta) < 1e-13;
        keeps_length =
          keeps_length &&
          std::abs(R.rotate(Tensor<1, 3>({3., 0., 4.})).norm() - 5.) < 1e-14;
        composes =
          composes && (angle > 1.5 ||
                       relative_error(R.after(R).vector(), 2. * theta) < 1e-13);
      }
    print("a rotation knows its vector", agree);
    print("it keeps lengths", keeps_length);
    print("twice the same is twice the vector", composes);
  }



  /// d R = [w x] R with w = T d theta, by central differences.
  void
  test_spin()
  {
    const Tensor<1, 3> r({0.3, -0.4, 1.1}), d({0.2, 0.5, -0.6});
    bool               is_derivative = true;
    for (const double scale : {1e-3, 0.4, 1.})
      {
        const Tensor<1, 3> theta = scale * some_vector;
        const double       h     = 1e-5;
        const Tensor<1, 3> difference =
          (FiniteRotation::from_vector(theta + h * d).displacement(r) -
           FiniteRotation::from_vector(theta - h * d).displacement(r)) /
          (2. * h);
        const Tensor<1, 3> expected =
          cross_product_3d(spin_of_rotation_vector(theta) * d,
                           FiniteRotation::from_vector(theta).rotate(r));
        is_derivative =
          is_derivative && relative_error(difference, expected) < 1e-9;
      }
    print("T gives the spin", is_derivative);
  }



  /// The nodes @p arms, shared by the ranks, displaced by @p state; in 2D and
  /// 3D.
  template <int dim>
  RigidState<dim>
  found_state(const std::vector<Tensor<1, dim>> &arms,
              const RigidState<dim>             &state)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                       n    = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const auto share =
      Utilities::create_evenly_distributed_partitioning(rank, n, arms.size());
    IndexSet owned(arms.size() * dim);
    for (const auto i : share)
      owned.add_range(i * dim, (i + 1) * dim);
    LA::Vector                  u(owned, MPI_COMM_WORLD);
    std::vector<RigidNode<dim>> nodes;
    for (const auto i : share)
      {
        nodes.push_back({{}, arms[i]});
        for (unsigned int d = 0; d < dim; ++d)
          {
            nodes.back().dofs[d] = i * dim + d;
            u(i * dim + d)       = state.displacement(arms[i])[d];
          }
      }
    u.compress(VectorOperation::insert);
    const ClosestRigidState<dim> closest(nodes, MPI_COMM_WORLD);
    print("  a rotation is determined", closest.determines_rotation());
    return closest.state_of(u, nodes, nullptr);
  }



  template <int dim>
  void
  test_closest(const std::string &what, const std::vector<Tensor<1, dim>> &arms)
  {
    print(what);
    bool is_exact = true;
    for (const double angle : {1e-9, 0.1, 2., 3.14})
      {
        RigidState<dim> state;
        Tensor<1, 3>    theta;
        theta[2] = angle;
        if (dim == 3)
          theta = angle / some_vector.norm() * some_vector;
        state.rotation       = FiniteRotation::from_vector(theta);
        state.translation[0] = 2. * angle;
        const auto found     = found_state(arms, state);
        is_exact =
          is_exact && relative_error(found.rotation.vector(), theta) < 1e-11 &&
          (found.translation - state.translation).norm() < 1e-11 * angle;
      }
    print("  found again, small ones with all digits", is_exact);
  }



  void
  test_masters()
  {
    // rigid motions of the corners of a plate, rotations about (5, 0)
    FullMatrix<double> map(8, 3);
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double x = (i % 2 == 0 ? -5. : 3.), y = (i < 2 ? 0. : 1.);
        map(2 * i, 0)     = 1.;
        map(2 * i + 1, 1) = 1.;
        map(2 * i, 2)     = -y / 5.;
        map(2 * i + 1, 2) = x / 5.;
      }
    const auto rows = independent_rows(map);
    print("three displacements stand for a motion", rows.size() == 3);
    print("they are independent", independence_of(rows, map) > 0.5);
    print("two nodes' heights alone are not",
          independence_of({1, 3, 5}, map) < 1e-12);
    FullMatrix<double> flat(2, 2);
    flat(0, 0) = flat(1, 0) = flat(0, 1) = flat(1, 1) = 1.;
    print("what is dependent is left out", independent_rows(flat).size() == 1);
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_rotations();
  test_spin();
  test_closest<2>("2D: a line",
                  {Tensor<1, 2>({1., 0.}),
                   Tensor<1, 2>({2., 1.}),
                   Tensor<1, 2>({3., 2.})});
  test_closest<3>("3D: a plane",
                  {Tensor<1, 3>({1., 0., 2.}),
                   Tensor<1, 3>({3., 1., 2.}),
                   Tensor<1, 3>({-2., 5., 2.}),
                   Tensor<1, 3>({0., 4., 2.})});
  test_closest<3>("3D: a body",
                  {Tensor<1, 3>({1., 0., 0.}),
                   Tensor<1, 3>({0., 1., 7.}),
                   Tensor<1, 3>({0., 0., 1.}),
                   Tensor<1, 3>({4., 4., 4.})});
  test_masters();
}
