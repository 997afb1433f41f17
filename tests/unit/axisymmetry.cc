// Sections of bodies of revolution: internal and external forces, their
// tangent, homogeneous deformations, orders of convergence, what is refused.

#include "solid_problem.h"

#include <stickslip/solid/axisymmetry.h>
#include <stickslip/solid/neo_hookean.h>
#include <stickslip/solid/simo_miehe.h>
#include <stickslip/solid/small_strain_plasticity.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace solid_test;

namespace
{
  /// The unit square beside the axis, or a distorted one at a distance.
  void
  make_section(Problem<2> &problem, const bool distorted)
  {
    if (distorted)
      {
        problem.distort();
        problem.refine_one_cell();
      }
    problem.bodies.cross_section.is_axisymmetric = true;
    problem.bodies.cross_section.radius_of_axis  = 1e-10;
    problem.bodies.bodies[0].reaches_axis        = !distorted;
  }



  void
  test_tangents()
  {
    for (const unsigned int degree : {1, 2})
      for (const bool distorted : {true, false})
        {
          Problem<2> problem(degree);
          make_section(problem, distorted);
          auto spring      = condition("spring", {2});
          spring.stiffness = 7.;
          spring.direction = "1, 2";
          // on the axis, too, where there is no area
          const std::vector<unsigned int> loaded = {0, 1, 3};
          problem.finish(
            steel<SaintVenantKirchhoff>(),
            {{"gas", condition("follower pressure", loaded, "20*(1+x*y)*t")},
             {"spring", spring},
             {"weight", condition("body force", {}, "x; -1")}});
          test_differences(problem,
                           distorted ? "distorted, " : "at the axis, ",
                           degree,
                           1e-8);
        }
    const auto test_mean = [](const std::string                     &name,
                              const std::shared_ptr<ConstitutiveLaw> law) {
      Problem<2> problem(1);
      make_section(problem, true);
      problem.finish(law, {}, /*with_mean_dilatation=*/true);
      test_differences(problem, name + ", ", 1, 1e-6);
    };
    test_mean("B-bar", steel<LinearElastic>());
    test_mean("F-bar", steel<SaintVenantKirchhoff>());
    test_mean("plastic F-bar", plastic<SimoMiehe>());
    test_mean("plastic B-bar", plastic<SmallStrainPlasticity>());
  }



  /// All around: a weight, and a pressure that follows.
  void
  test_resultants()
  {
    Problem<2> problem(2);
    make_section(problem, false);
    problem.finish(steel<SaintVenantKirchhoff>(),
                   {{"weight", condition("body force", {}, "0; -3")}});
    const auto along_axis = [](const Problem<2> &problem,
                               const LA::Vector &force) {
      double     sum = 0.;
      const auto dofs =
        DoFTools::extract_dofs(problem.dof_handler,
                               ComponentMask(std::vector<bool>{false, true}));
      for (const auto dof : dofs)
        sum += force(dof);
      return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    };
    LA::Vector force;
    problem.residual(0., &force);
    print("weight of a cylinder",
          std::abs(along_axis(problem, force) + 3. * numbers::PI) < 1e-12);

    Problem<2> pressed(2);
    make_section(pressed, false);
    pressed.finish(steel<SaintVenantKirchhoff>(),
                   {{"gas", condition("follower pressure", {3}, "5")}});
    pressed.interpolate([](const Point<2> &p) {
      return Tensor<1, 2>({0.25 * p[0], 0.1 * p[0] * p[0]});
    });
    pressed.residual(0., &force);
    print("follower pressure on what has become larger",
          std::abs(along_axis(pressed, force) +
                   5. * numbers::PI * 1.25 * 1.25) < 1e-12);

    Problem<2> closed(2);
    make_section(closed, true);
    closed.finish(steel<SaintVenantKirchhoff>(),
                  {{"gas", condition("follower pressure", {0, 1, 2, 3}, "5")}});
    closed.interpolate([](const Point<2> &p) {
      return Tensor<1, 2>({0.2 * p[1] * p[1], -0.3 * p[0] * p[1]});
    });
    closed.residual(0., &force);
    print("follower pressure on a closed surface",
          std::abs(along_axis(closed, force)) < 1e-10 &&
            force.linfty_norm() > 0.1);
  }



  /// u = (a x, b y) stays with any law: F = diag(1 + a, 1 + b, 1 + a).
  void
  test_patch(const std::string                     &name,
             const std::shared_ptr<ConstitutiveLaw> law,
             const unsigned int                     degree,
             const bool                             with_mean_dilatation)
  {
    for (const bool distorted : {true, false})
      {
        Problem<2> problem(degree);
        make_section(problem, distorted);
        // the axis holds itself
        const std::vector<unsigned int> outside = {1, 2, 3};
        auto held = condition("displacement", outside, "0.1*t*x; -0.2*t*y");
        if (distorted)
          held.boundary.push_back("0");
        problem.finish(law, {{"hold", held}}, with_mean_dilatation);
        problem.interpolate([](const Point<2> &) { return Tensor<1, 2>(); });
        problem.solve(1., 8);
        Tensor<2, 3> F, P;
        F[0][0] = F[2][2] = 1.1;
        F[1][1]           = 0.8;
        law->evaluate(F, {}, {}, P, nullptr);
        const auto expected = law->cauchy_stress(F, P);
        print(case_name<2>(name + (distorted ? ", distorted patch"
                                             : ", patch at the axis"),
                           degree),
              problem.stress_error(expected) < 1e-11 * expected.norm());
      }
  }



  /// Square of the error of the displacement, all around.
  double
  squared_error(Problem<2> &problem, const VectorFunction<2>::Formula &exact)
  {
    const QGauss<2>             quadrature(6);
    FEValues<2>                 fe_values(problem.mapping[0],
                          problem.fe,
                          quadrature,
                          update_values | update_quadrature_points |
                            update_JxW_values);
    std::vector<Vector<double>> values(quadrature.size(), Vector<double>(2));
    double                      sum = 0.;
    for (const auto &cell : problem.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          fe_values.get_function_values(problem.u, values);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const Point<2>    &X = fe_values.quadrature_point(q);
              const Tensor<1, 2> u({values[q](0), values[q](1)});
              sum += (u - exact(X)).norm_square() * 2. * numbers::PI * X[0] *
                     fe_values.JxW(q);
            }
        }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }



  /// u = (x^3 y, -x^2 y^2) with the body force that it needs.
  void
  test_convergence()
  {
    const double E = 100., nu = 0.3, mu = E / (2. * (1. + nu)),
                 lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
    std::ostringstream force;
    force.precision(16);
    force << -(4. * lambda + 12. * mu) << "*x*y; " << 4. * mu << "*y^2 - "
          << 2. * lambda << "*x^2";
    const auto exact = [](const Point<2> &p) {
      return Tensor<1, 2>(
        {p[0] * p[0] * p[0] * p[1], -p[0] * p[0] * p[1] * p[1]});
    };
    for (const unsigned int degree : {1, 2})
      {
        std::vector<double> errors;
        for (unsigned int level = 1; level < 4; ++level)
          {
            Problem<2> problem(degree);
            problem.triangulation.refine_global(level);
            make_section(problem, false);
            problem.finish(
              steel<LinearElastic>(),
              {{"hold",
                condition("displacement", {1, 2, 3}, "x^3*y; -x^2*y^2")},
               {"force", condition("body force", {}, force.str())}});
            problem.solve(1., 1);
            errors.push_back(std::sqrt(squared_error(problem, exact)));
          }
        const double order = std::log2(errors[1] / errors[2]);
        print(case_name<2>("order of convergence", degree),
              std::abs(order - (degree + 1.)) < 0.05);
      }
  }



  void
  test_held()
  {
    Problem<2> problem(1);
    make_section(problem, false);
    problem.finish(steel<LinearElastic>(), {});
    for (const auto &motion : free_rigid_motions(*problem.boundary_conditions,
                                                 problem.bodies,
                                                 problem.mapping,
                                                 problem.dof_handler))
      print(motion.text());
    const auto refuse = [](const BoundaryConditionParameters &parameters) {
      print_error(
        [&] { check_is_axisymmetric(parameters, "Boundary conditions/c"); });
    };
    auto motion        = condition("rigid motion", {});
    motion.translation = "0; t";
    refuse(motion);
    motion.translation = "t; 0";
    refuse(motion);
    motion.translation = "free; 0";
    refuse(motion);
    motion.translation = "0; free";
    motion.force       = "1; 2";
    refuse(motion);
    motion.force          = "0; 2";
    motion.rotation_angle = "10*t";
    refuse(motion);
    motion.rotation_angle = "";
    motion.torque         = "1";
    refuse(motion);
    auto traction       = condition("traction", {1}, "1; 0");
    traction.components = VectorComponents::cylindrical;
    refuse(traction);
    auto periodic            = condition("periodic", {0});
    periodic.second_boundary = {"1"};
    periodic.direction       = "x";
    refuse(periodic);
    periodic.direction = "y";
    refuse(periodic);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_tangents();
  test_resultants();
  for (const unsigned int degree : {1, 2})
    {
      test_patch("linear", steel<LinearElastic>(), degree, false);
      test_patch("neo-Hookean", steel<NeoHookean>(), degree, false);
    }
  test_patch("B-bar", steel<LinearElastic>(), 1, true);
  test_patch("F-bar", steel<NeoHookean>(), 1, true);
  test_convergence();
  test_held();
}
