// The cells of the contact zone and of its edges, on both bodies; indicators of
// a symmetric problem are symmetric.

#include "print.h"
#include "solved_case.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

using namespace stickslip;

namespace
{
  /// A block of 16 cells along x above one of 20, whose upper surface has the
  /// shape of a roof: they touch in the middle.
  template <int dim>
  std::string
  blocks(const std::string &contact)
  {
    const bool        is_3d = dim == 3;
    const std::string s     = is_3d ? "; z" : "";
    return "set Dimension = " + std::to_string(dim) +
           R"(
      subsection Materials
        subsection steel
          set Law = linear elastic
          set Young's modulus = 100
          set Poisson's ratio = 0.3
        end
      end
      subsection Bodies
        subsection upper
          set Generator = subdivided_hyper_rectangle
          set Arguments = )" +
           (is_3d ? "16, 4, 2 : -2, 0, 0 : 2, 1, 1" : "16, 4 : -2, 0 : 2, 1") +
           R"( : true
          set Material = steel
        end
        subsection lower
          set Generator = subdivided_hyper_rectangle
          set Arguments = )" +
           (is_3d ? "20, 4, 3 : -2, -1, 0 : 2, 0, 1"
                  : "20, 4 : -2, -1 : 2, 0") +
           " : true\nset Material = steel\nset Coordinates = x; y - (1 + "
           "y)*0.05*x^2" +
           s + R"(
        end
      end
      subsection Boundary conditions
        subsection foot
          set Body = lower
          set Boundary = 2
          set Type = displacement
          set Value = )" +
           (is_3d ? "0; 0; 0" : "0; 0") + R"(
        end
        subsection press
          set Body = upper
          set Boundary = 3
          set Type = displacement
          set Value = )" +
           (is_3d ? "0; -0.02; 0" : "0; -0.02") + R"(
        end
      end
      subsection Contact
        subsection pair
          set Slave body = upper
          set Slave boundary = 2
          set Master body = lower
          set Master boundary = 3
          )" +
           contact + "\nend\nend\n";
  }



  template <int dim>
  void
  print_zone(SolvedCase<dim> &solved, const std::string &rule, const double d)
  {
    const ErrorEstimate estimate = solved.estimate(rule, d);
    double              n[2] = {0., 0.}, left[2] = {0., 0.};
    for (const auto &cell :
         solved.problem.layout().dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() &&
          estimate.indicators[cell->active_cell_index()] > 0.)
        {
          const unsigned int body =
            solved.problem.bodies().body_of(cell->material_id());
          n[body] += 1.;
          left[body] = std::max(left[body], -cell->center()[0]);
        }
    std::ostringstream text;
    text << "  " << rule << ", distance " << d << ":";
    for (unsigned int body = 0; body < 2; ++body)
      text << (body == 0 ? " " : ", ")
           << solved.problem.bodies().bodies[body].name << ' '
           << Utilities::MPI::sum(n[body], MPI_COMM_WORLD)
           << " cells up to x = "
           << Utilities::MPI::max(left[body], MPI_COMM_WORLD);
    print(text.str());
  }



  /// Largest difference of the indicators of two cells that are mirrored, over
  /// the largest indicator. Of one rank.
  template <int dim>
  double
  asymmetry(SolvedCase<dim> &solved, const std::string &estimator)
  {
    const ErrorEstimate           estimate = solved.estimate(estimator);
    std::map<std::string, double> at;
    const auto                    key = [](Point<dim> p, const double sign) {
      p[0] *= sign;
      std::ostringstream text;
      for (unsigned int c = 0; c < dim; ++c)
        text << std::lround(1e6 * p[c]) << ' ';
      return text.str();
    };
    for (const auto &cell :
         solved.problem.layout().dof_handler.active_cell_iterators())
      at[key(cell->center(), 1.)] =
        estimate.indicators[cell->active_cell_index()];
    double difference = 0.;
    for (const auto &cell :
         solved.problem.layout().dof_handler.active_cell_iterators())
      difference =
        std::max(difference,
                 std::abs(estimate.indicators[cell->active_cell_index()] -
                          at.at(key(cell->center(), -1.))));
    return difference / estimate.indicators.linfty_norm();
  }



  template <int dim>
  void
  test(const std::string &title, const std::string &contact)
  {
    print(title);
    SolvedCase<dim> solved(blocks<dim>(contact), 12);
    print_zone(solved, "contact zone", 0.);
    print_zone(solved, "contact zone", 0.02);
    print_zone(solved, "contact edge", 0.);
    print_zone(solved, "contact edge", 0.3);
    // On one rank. The kink of |g| is integrated over polygons that are cut
    // into triangles in 3D, which are not symmetric. At the vertex in the
    // middle the nodal rule takes one of two master faces, and with it its
    // normal.
    if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
      for (const std::string name : {"residual", "recovery", "Kelly"})
        if (!(asymmetry(solved, name) <
              (dim == 3 && name == "residual" ? 1e-3 : 1e-6)))
          print(name + " is not symmetric");
    std::ostringstream text;
    text.precision(4);
    text << " ";
    for (const std::string name : {"residual", "recovery", "Kelly"})
      text << ' ' << name << ' ' << solved.estimate(name).relative();
    print(text.str());
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("2D", "");
  test<2>("2D, friction",
          "set Friction = Coulomb\nset Friction coefficient = 0.1");
  test<2>("2D, nodal", "set Quadrature = nodal");
  test<2>("2D, Gauss", "set Quadrature = Gauss");
  test<3>("3D", "");
}
