// Prescribed displacements as constraints: rigid motions, oblique symmetry,
// contradictions, and the motions that nothing holds.

#include "solid_problem.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

using namespace solid_test;

namespace
{
  template <int dim>
  void
  test_rigid_rotation()
  {
    Problem<dim> problem(2);
    problem.distort();
    auto turn            = condition("rigid motion", {});
    turn.translation     = (dim == 2 ? "t; 0" : "t; 0; 0");
    turn.rotation_angle  = "90*t";
    turn.rotation_axis   = "1, 1, 1";
    turn.rotation_centre = (dim == 2 ? "0.5, 0.5" : "0.5, 0.5, 0.5");
    problem.finish(steel<SaintVenantKirchhoff>(), {{"turn", turn}});
    problem.solve(1., 1);
    print(case_name<dim>("quarter turn leaves no stress", 2),
          problem.stress_error(SymmetricTensor<2, 3>()) < 1e-11);
    const auto exact = [](const Point<dim> &p) {
      Tensor<1, dim> x;
      if (dim == 2)
        {
          x[0] = 0.5 - (p[1] - 0.5);
          x[1] = 0.5 + (p[0] - 0.5);
        }
      else
        {
          // 90 degrees about (1,1,1)/sqrt(3) through (.5,.5,.5)
          const double third = 1. / 3., root = 1. / std::sqrt(3.);
          for (unsigned int d = 0; d < dim; ++d)
            x[d] = 0.5 + third * (p[d] - 0.5) +
                   (third - root) * (p[(d + 1) % 3] - 0.5) +
                   (third + root) * (p[(d + 2) % 3] - 0.5);
        }
      x[0] += 1.;
      return Tensor<1, dim>(x - p);
    };
    print(case_name<dim>("quarter turn ends where it should", 2),
          problem.displacement_error(exact) < 1e-12);
  }



  /// A block turned by 30 degrees between two oblique symmetry planes, pulled
  /// at a third side: homogeneous uniaxial stress.
  template <int dim>
  void
  test_oblique_symmetry()
  {
    Problem<dim>         problem(1);
    const double         c = std::cos(numbers::PI / 6), s = 0.5;
    const Tensor<1, dim> pull = [&]() {
      Tensor<1, dim> direction;
      direction[0] = c;
      direction[1] = s;
      return direction;
    }();
    problem.transform([=](const Point<dim> &p) {
      Point<dim> turned = p;
      turned[0]         = c * p[0] - s * p[1];
      turned[1]         = s * p[0] + c * p[1];
      return turned;
    });
    problem.refine_one_cell();
    auto                                   law  = steel<LinearElastic>();
    std::shared_ptr<const ConstitutiveLaw> used = law;
    if (dim == 2)
      used = std::make_shared<PlaneStress>(law);
    problem.finish(used,
                   {{"planes",
                     condition("symmetry",
                               dim == 2 ? std::vector<unsigned int>{0, 2}
                                        : std::vector<unsigned int>{0, 2, 4})},
                    {"pull", condition("pressure", {1}, "-0.5*t")}});
    problem.solve(2., 1);
    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = i; j < 2; ++j)
        stress[i][j] = pull[i] * pull[j];
    print(case_name<dim>("oblique symmetry planes", 1),
          problem.stress_error(stress) < 1e-11);
  }



  template <int dim>
  void
  test_rigid_body()
  {
    Problem<dim> problem(1, true);
    auto         turn   = condition("rigid motion", {});
    turn.body           = "tool";
    turn.rotation_angle = "45*t";
    problem.finish(
      steel<SaintVenantKirchhoff>(),
      {{"turn", turn},
       {"base", condition("displacement", {2}, dim == 2 ? "0; 0" : "0; 0; 0")},
       {"top", condition("traction", {3}, dim == 2 ? "1; 0" : "1; 0; 0")}});
    const Constraints constraints = problem.increment_constraints(1.);
    LA::SparseMatrix  matrix;
    LA::Vector        rhs;
    problem.assemble_tangent(1., constraints, matrix, rhs);
    double smallest = 1e10;
    for (const auto dof : problem.owned)
      smallest = std::min(smallest, matrix.diag_element(dof));
    print(case_name<dim>("diagonal is positive", 1),
          Utilities::MPI::min(smallest, MPI_COMM_WORLD) > 1.);
    print(case_name<dim>("Newton converges beside a rigid body", 1),
          problem.solve(1., 7) < 1e-12);
    for (const FreeMotion &motion :
         free_rigid_motions(*problem.boundary_conditions,
                            problem.bodies,
                            problem.mapping,
                            problem.dof_handler))
      print(motion.text());
  }



  template <int dim>
  void
  test_unheld(const NamedList<BoundaryConditionParameters> &conditions)
  {
    Problem<dim> problem(1);
    problem.finish(steel<LinearElastic>(), conditions);
    std::string text;
    for (const FreeMotion &motion :
         free_rigid_motions(*problem.boundary_conditions,
                            problem.bodies,
                            problem.mapping,
                            problem.dof_handler))
      text += motion.text() + "; ";
    print(text.empty() ? "all held" : text);
  }



  void
  test_all_unheld()
  {
    test_unheld<2>({});
    test_unheld<2>({{"base", condition("symmetry", {2})}});
    auto pin  = condition("displacement", {}, "0; 0");
    pin.where = "x < 1e-9 && y < 1e-9";
    test_unheld<2>({{"pin", pin}});
    test_unheld<3>({{"pin", condition("displacement", {4}, "free; free; 0")}});
    auto spring      = condition("spring", {0});
    spring.stiffness = 1.;
    test_unheld<3>({{"bed", spring}});
    auto periodic            = condition("periodic", {0});
    periodic.second_boundary = {"1"};
    periodic.direction       = "x";
    test_unheld<2>({{"sides", periodic}, {"base", condition("symmetry", {2})}});
  }



  void
  test_errors()
  {
    const auto attempt = [](const BoundaryConditionParameters &parameters) {
      print_error([&]() {
        Problem<2> problem(1);
        problem.finish(steel<LinearElastic>(),
                       {{"first", condition("displacement", {0}, "0; 0")},
                        {"second", parameters}});
        problem.increment_constraints(1.);
      });
    };
    attempt(condition("displacement", {2}, "0; free"));
    attempt(condition("displacement", {2}, "free; 0.1*(1-x)"));
    attempt(condition("displacement", {7}, "0; 0"));
    attempt(condition("displacement", {2}, "0"));
    attempt(condition("traction", {2}, "0; sinn(x)"));
    attempt(condition("pressure", {}, "1"));
    auto spring      = condition("spring", {1});
    spring.stiffness = 1.;
    spring.direction = "0, 0";
    attempt(spring);
    auto nowhere  = condition("displacement", {}, "0; 0");
    nowhere.where = "x > 5";
    attempt(nowhere);
    auto unknown = condition("symmetry", {1});
    unknown.body = "blok";
    attempt(unknown);
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_rigid_rotation<2>();
  test_rigid_rotation<3>();
  test_oblique_symmetry<2>();
  test_oblique_symmetry<3>();
  test_rigid_body<2>();
  test_rigid_body<3>();
  test_all_unheld();
  test_errors();
}
