// Section Refinement: which cells, how many, the same on any number of ranks;
// curved bodies with hanging nodes have no gaps, so that a rotation is free of
// stress.

#include "case_problem.h"
#include "print.h"

#include <stickslip/mesh/local_refinement.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  const std::string material = R"(
    subsection Materials
      subsection rubber
        set Law = St Venant-Kirchhoff
        set Young's modulus = 10
        set Poisson's ratio = 0.3
      end
    end
  )";



  std::string
  with_rules(const std::string &rules)
  {
    return "set Dimension = 2\n" + material + R"(
      subsection Bodies
        subsection upper
          set Generator = subdivided_hyper_rectangle
          set Arguments = 8, 4 : 0, 1.1 : 4, 3.1 : true
          set Material = rubber
        end
        subsection lower
          set Generator = hyper_ball
          set Arguments = 2, 0 : 1
          set Material = rubber
        end
      end
      subsection Mesh
        set Global refinements = 1
      end
      subsection Contact
        subsection pair
          set Slave body = upper
          set Slave boundary = 2
          set Master body = lower
          set Master boundary = 0
        end
      end
      subsection Refinement
    )" + rules +
           "end\n";
  }



  void
  test_rules()
  {
    for (const std::string rule :
         {"set Body = upper\n set First corner = 1, 1\n"
          "set Second corner = 1.5, 1.6\n set Levels = 2",
          "set Type = sphere\n set Centre = 2, 1\n set Radius = 0.2",
          "set Type = condition\n set Condition = x > 3.4 & y < 1.3",
          "set Type = sphere\n set Centre = 2, -1.01\n set Radius = 0.02\n"
          "set Levels = 2", // beyond the vertices of coarse cells
          "set Type = boundary\n set Body = lower\n set Boundary = 0\n"
          "set Distance = 0.1\n set Levels = 2",
          "set Type = contact\n set Contact pair = pair\n"
          "set Distance = 0.25\n set Levels = 3",
          "set Type = contact\n set Contact pair = pair\n"
          "set Distance = 0.25\n set Levels = 3\n set Buffer layers = 2"})
      {
        const TextParameters parameters(
          with_rules("subsection rule\n" + rule + "\nend\n"));
        const Mesh<2> mesh =
          build_mesh<2>(parameters.mesh, parameters.bodies, {}, MPI_COMM_WORLD);
        print(describe_levels(mesh.cells_by_level).front());
      }
  }



  /// A rotation by 30 degrees of a body with a curved boundary.
  template <int dim>
  void
  test_rotation(const unsigned int degree)
  {
    const std::string d = std::to_string(dim);
    CaseProblem<dim>  problem("set Dimension = " + d + "\nset Degree = " +
                             std::to_string(degree) + "\n" + material + R"(
      subsection Bodies
        subsection ball
          set Generator = hyper_ball
          set Material = rubber
        end
      end
      subsection Mesh
        set Global refinements = 1
      end
      subsection Refinement
        subsection side
          set Type = condition
          set Condition = x > 0.4 & y > -0.1
          set Levels = )" + (dim == 2 ? "3" : "1") +
                             "\nend\nend\n");
    const auto       &dofs = problem.problem.layout();
    std::map<types::global_dof_index, Point<dim>> points;
    DoFTools::map_dofs_to_support_points(dofs.mapping,
                                         dofs.dof_handler,
                                         points);
    LA::BlockVector x      = problem.problem.zero_state();
    const double    cosine = std::sqrt(0.75), sine = 0.5;
    for (unsigned int c = 0; c < dim; ++c)
      {
        std::vector<bool> selected(dim, false);
        selected[c] = true;
        for (const auto i :
             DoFTools::extract_dofs(dofs.dof_handler, ComponentMask(selected)))
          {
            const Point<dim> &p = points.at(i);
            x.block(0)(i)       = c == 0   ? (cosine - 1.) * p[0] - sine * p[1]
                                  : c == 1 ? sine * p[0] + (cosine - 1.) * p[1]
                                           : 0.;
          }
      }
    x.compress(VectorOperation::insert);
    problem.problem.begin_step(1., problem.problem.zero_state());
    problem.problem.begin_iteration(x);
    problem.problem.residual(x);
    print(d + "D Q" + std::to_string(degree) + ": " +
          describe_levels(problem.mesh.cells_by_level).front());
    print("  hanging nodes", problem.mesh.triangulation->has_hanging_nodes());
    print("  a rotation is free of stress",
          problem.problem.nodal_forces().linfty_norm() < 1e-12);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_rules();
  for (const unsigned int degree : {1, 2, 3})
    test_rotation<2>(degree);
  for (const unsigned int degree : {1, 2})
    test_rotation<3>(degree);
}
