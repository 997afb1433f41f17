// Internal and external forces and their tangent on small meshes, distorted,
// locally refined and distributed.

#include "solid_problem.h"

#include <stickslip/solid/neo_hookean.h>
#include <stickslip/solid/simo_miehe.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace solid_test;

namespace
{
  /// St Venant-Kirchhoff, follower pressure, springs and dead loads on a
  /// distorted and locally refined mesh.
  template <int dim>
  void
  test_tangent(const unsigned int degree)
  {
    Problem<dim> problem(degree);
    problem.distort();
    problem.refine_one_cell();
    auto spring            = condition("spring", {2});
    spring.stiffness       = 7.;
    spring.direction       = (dim == 2 ? "1, 2" : "1, 2, -1");
    auto other_spring      = condition("spring", {3});
    other_spring.stiffness = 3.;
    problem.finish(
      steel<SaintVenantKirchhoff>(),
      {{"gas", condition("follower pressure", {1, 3}, "20*(1+x*y)*t")},
       {"spring", spring},
       {"bed", other_spring},
       {"weight",
        condition("body force", {}, dim == 2 ? "0; -1" : "0; 0; -1")}});

    test_differences(problem, "", degree, 1e-8);
  }



  /// F-bar and B-bar elements, elastic and in plastic flow.
  template <int dim>
  void
  test_mean_dilatation_tangent(const std::string                     &name,
                               const std::shared_ptr<ConstitutiveLaw> law)
  {
    Problem<dim> problem(1);
    problem.distort();
    problem.refine_one_cell();
    problem.finish(law, {}, /*with_mean_dilatation=*/true);
    test_differences(problem, name + ", ", 1, 1e-6);
  }



  /// Viscous stabilization: its tangent, and its force and work on a body that
  /// moves without deformation.
  template <int dim>
  void
  test_stabilization()
  {
    Problem<dim> problem(1);
    problem.distort();
    problem.refine_one_cell();
    problem.finish(steel<SaintVenantKirchhoff>(), {});
    const LA::Vector u_old(problem.u);
    auto            &stabilization = problem.assembler->stabilization();
    stabilization.set_start(u_old);
    stabilization.activate(0.3, 5.);
    stabilization.begin_step(0.25);
    test_differences(problem, "stabilized, ", 1, 1e-8);

    const Tensor<1, dim> shift = Point<dim>::unit_vector(0) * 0.01;
    problem.interpolate([&](const Point<dim> &) { return shift; });
    const LA::Vector residual = problem.residual(0.);
    const double     volume =
      GridTools::volume(problem.dof_handler.get_triangulation());
    const auto corners =
      GridTools::compute_bounding_box(problem.dof_handler.get_triangulation())
        .get_boundary_points();
    const double L = Utilities::MPI::max(corners.first.distance(corners.second),
                                         MPI_COMM_WORLD);
    const double force = 0.3 * 5. / (L * L) *
                         problem.assembler->longitudinal_modulus(0) / 0.25 *
                         0.01 * volume;
    LA::Vector direction(residual);
    direction = problem.u;
    direction *= 1. / 0.01;
    print(case_name<dim>("stabilization force of a translation", 1),
          std::abs(residual * direction / force - 1.) < 1e-12);
    print(case_name<dim>("stabilization work of a translation", 1),
          std::abs(problem.assembler->stabilization_work(problem.u) /
                     (force * 0.01) -
                   1.) < 1e-12);
    stabilization.begin_step(0.);
    print(case_name<dim>("no stabilization without a step", 1),
          problem.residual(0.).linfty_norm() < 1e-12 * force);
  }



  /// A closed surface under constant pressure carries no resultant, however
  /// it is deformed.
  template <int dim>
  void
  test_closed_surface(const unsigned int degree)
  {
    Problem<dim> problem(degree);
    problem.distort();
    std::vector<unsigned int> all(2 * dim);
    for (unsigned int id = 0; id < 2 * dim; ++id)
      all[id] = id;
    problem.finish(steel<SaintVenantKirchhoff>(),
                   {{"gas", condition("follower pressure", all, "5")}});
    problem.interpolate([](const Point<dim> &p) {
      Tensor<1, dim> u;
      u[0] = 0.2 * p[1] * p[1];
      u[1] = -0.3 * p[0] * p[1];
      return u;
    });
    LA::Vector force;
    problem.residual(0., &force);
    double worst = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        std::vector<bool> mask(dim, false);
        mask[d]            = true;
        double         sum = 0.;
        const IndexSet dofs =
          DoFTools::extract_dofs(problem.dof_handler, ComponentMask(mask));
        for (const auto dof : dofs)
          sum += force(dof);
        worst =
          std::max(worst, std::abs(Utilities::MPI::sum(sum, MPI_COMM_WORLD)));
      }
    print(case_name<dim>("follower pressure on a closed surface", degree),
          worst < 1e-12 && force.linfty_norm() > 0.1);
  }



  /// Displacements that are linear on the boundary are so inside.
  template <int dim>
  void
  test_patch(const unsigned int degree)
  {
    Problem<dim> problem(degree);
    problem.distort();
    problem.refine_one_cell();
    std::vector<unsigned int> all(2 * dim);
    for (unsigned int id = 0; id < 2 * dim; ++id)
      all[id] = id;
    problem.finish(steel<LinearElastic>(),
                   {{"hold",
                     condition("displacement",
                               all,
                               dim == 2 ? "t*0.01*x; t*0.02*x"
                                        : "t*0.01*x; t*0.02*x; 0")}});
    problem.interpolate([](const Point<dim> &) { return Tensor<1, dim>(); });
    const Constraints     constraints = problem.increment_constraints(1.);
    std::vector<IndexSet> owned_sets =
      Utilities::MPI::all_gather(MPI_COMM_WORLD, problem.owned);
    IndexSet active;
    DoFTools::extract_locally_active_dofs(problem.dof_handler, active);
    print(case_name<dim>("constraints are the same on all ranks", degree),
          constraints.is_consistent_in_parallel(owned_sets,
                                                active,
                                                MPI_COMM_WORLD));

    problem.solve(1., 1);
    const double          lambda = 100. * 0.3 / (1.3 * 0.4), mu = 100. / 2.6;
    SymmetricTensor<2, 3> stress;
    stress[0][0] = (lambda + 2. * mu) * 0.01;
    stress[1][1] = stress[2][2] = lambda * 0.01;
    stress[0][1]                = mu * 0.02;
    print(case_name<dim>("patch of linear displacements", degree),
          problem.stress_error(stress) < 1e-11);
    LA::Vector reactions = problem.residual(1.);
    print(case_name<dim>("second step changes nothing", degree),
          problem.solve(1., 1) < 1e-14 && reactions.linfty_norm() > 0.01);
  }



  /// A homogeneous deformation stays one with the mean dilatation: linear
  /// displacements on the boundary, the law's own stress inside.
  template <int dim>
  void
  test_mean_dilatation_patch(const std::string                     &name,
                             const std::shared_ptr<ConstitutiveLaw> law)
  {
    Problem<dim> problem(1);
    problem.distort();
    problem.refine_one_cell();
    std::vector<unsigned int> all(2 * dim);
    for (unsigned int id = 0; id < 2 * dim; ++id)
      all[id] = id;
    problem.finish(law,
                   {{"hold",
                     condition("displacement",
                               all,
                               dim == 2 ? "t*0.1*x; t*0.2*x - t*0.2*y"
                                        : "t*0.1*x; t*0.2*x - t*0.2*y; 0")}},
                   /*with_mean_dilatation=*/true);
    problem.interpolate([](const Point<dim> &) { return Tensor<1, dim>(); });
    problem.solve(1., 8);

    Tensor<2, 3> F, P;
    F[0][0]               = 1.1;
    F[1][0]               = 0.2;
    F[1][1]               = 0.8;
    F[2][2]               = 1.;
    const unsigned int  n = law->n_history_variables();
    std::vector<double> virgin(n), history(n);
    law->initialize_history(ArrayView<double>(virgin.data(), n));
    law->evaluate(F,
                  ArrayView<const double>(virgin.data(), n),
                  ArrayView<double>(history.data(), n),
                  P,
                  nullptr);
    const auto expected = law->cauchy_stress(F, P);
    print(case_name<dim>(name + ", patch of linear displacements", 1),
          problem.stress_error(expected) < 1e-11 * expected.norm());
  }



  void
  test_inadmissible_state()
  {
    Problem<2> problem(1);
    problem.finish(steel<SaintVenantKirchhoff>(), {});
    problem.residual(0.);
    print("undeformed state is admissible",
          problem.assembler->state_is_admissible());
    problem.interpolate([](const Point<2> &p) {
      Tensor<1, 2> u;
      u[0] = -2. * p[0];
      return u;
    });
    problem.residual(0.);
    print("inverted state is inadmissible",
          !problem.assembler->state_is_admissible());
    const InadmissibleState state = problem.assembler->inadmissible_state();
    print(state.reason + " in " + state.place.in_words() + ".");
  }



  template <int dim>
  void
  test_dimension()
  {
    for (const unsigned int degree : {1, 2})
      {
        test_tangent<dim>(degree);
        test_closed_surface<dim>(degree);
        test_patch<dim>(degree);
      }
    test_stabilization<dim>();
    test_mean_dilatation_tangent<dim>("B-bar", steel<LinearElastic>());
    test_mean_dilatation_tangent<dim>("F-bar", steel<SaintVenantKirchhoff>());
    test_mean_dilatation_tangent<dim>("plastic F-bar", plastic<SimoMiehe>());
    test_mean_dilatation_tangent<dim>("plastic B-bar",
                                      plastic<SmallStrainPlasticity>());
    test_mean_dilatation_patch<dim>("B-bar", steel<LinearElastic>());
    test_mean_dilatation_patch<dim>("F-bar", steel<NeoHookean>());
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_dimension<2>();
  test_dimension<3>();
  test_inadmissible_state();
}
