// How far the smooth surfaces behind facets are outside of them: arcs of
// facets of different sizes, flat parts beside them, chamfers; lines,
// quadrilaterals, triangles; the same on any number of ranks.

#include <stickslip/contact/surface/facet_rise.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "case_problem.h"
#include "print.h"

namespace
{
  std::string
  other_body_and_pair(const std::string &boundary)
  {
    return " subsection other\n  set Generator = hyper_cube\n"
           "  set Arguments = 10 : 11 : true\n  set Material = elastic\n"
           " end\nend\nsubsection Materials\n subsection elastic\n"
           "  set Young's modulus = 1000\n  set Poisson's ratio = 0.3\n end\n"
           "end\nsubsection Contact\n subsection pair\n"
           "  set Slave body = other\n  set Slave boundary = 0\n"
           "  set Master body = curved\n  set Master boundary = " +
           boundary + "\n end\nend\n";
  }



  /// A body of which boundary 3 (3D: 5) is the master surface (a convex slave
  /// may keep its facets); it never meets its slave.
  std::string
  case_with(const unsigned int dim,
            const std::string &cells,
            const std::string &coordinates)
  {
    const bool is_2d = dim == 2;
    return "set Dimension = " + std::to_string(dim) +
           "\nsubsection Bodies\n subsection curved\n"
           "  set Generator = subdivided_hyper_rectangle\n  set Arguments = " +
           cells + (is_2d ? ", 1 : 0, 0 : 1, 1" : ", 1 : 0, 0, 0 : 1, 1, 1") +
           " : true\n  set Coordinates = " + coordinates +
           "\n  set Material = elastic\n end\n" +
           other_body_and_pair(is_2d ? "3" : "5");
  }



  /// Likewise a mesh with a group 'curved'.
  std::string
  case_with_mesh(const std::string &name)
  {
    return "set Dimension = 3\nsubsection Bodies\n subsection curved\n"
           "  set Mesh file = " SOURCE_DIR "/../application/data/" +
           name + ".msh\n  set Material = elastic\n end\n" +
           other_body_and_pair("curved");
  }



  /// Calls @p look(face, nodes) for the master faces of a rank.
  template <int dim>
  void
  for_all_faces(
    const std::string                                              &prm,
    const std::function<void(const SurfaceFace<dim> &,
                             const std::vector<Tensor<1, dim>> &)> &look)
  {
    CaseProblem<dim> one(prm);
    const auto      &pair = *one.problem.contact().contact_pairs().front();
    for (const auto &face : pair.patch->owned_faces())
      look(face, face.undeformed_nodes());
  }



  /// Largest distance of the surface with rise, in units of the facets'
  /// largest rise, from the set where @p level is 0 (with unit gradient).
  template <int dim>
  double
  largest_error(
    const std::string                                   &prm,
    const std::function<double(const Tensor<1, dim> &)> &level,
    const std::function<bool(const Tensor<1, dim> &)>   &counts =
      [](const Tensor<1, dim> &) { return true; })
  {
    double error = 0., sagitta = 0.;
    for_all_faces<dim>(prm, [&](const auto &face, const auto &nodes) {
      if (!counts(nodes[0]))
        return;
      const bool           is_triangle = dim == 3 && nodes.size() == 3;
      const FaceShape<dim> shape(1,
                                 is_triangle
                                   ? ReferenceCells::Triangle
                                   : ReferenceCells::get_hypercube<dim - 1>());
      std::vector<double>  N;
      for (double a = 0.1; a < 1.; a += 0.2)
        for (double b = 0.1; b < (is_triangle ? 1. - a : 1.); b += 0.2)
          {
            Point<dim - 1> xi;
            xi[0] = a;
            if (dim == 3)
              xi[dim - 2] = b;
            shape.evaluate_values(xi, N);
            const double outside = level(interpolate<dim>(N, nodes));
            error   = std::max(error, std::abs(outside + rise_at(face, xi)));
            sagitta = std::max(sagitta, std::abs(outside));
          }
    });
    error   = Utilities::MPI::max(error, MPI_COMM_WORLD);
    sagitta = Utilities::MPI::max(sagitta, MPI_COMM_WORLD);
    return error / sagitta;
  }



  /// Of the slave, a face of 1 (x 1) that is normal to x.
  template <int dim>
  void
  print_slave_rises(const std::string &title, const std::string &prm)
  {
    CaseProblem<dim> one(prm);
    const auto      &pair  = *one.problem.contact().contact_pairs().front();
    double           least = 0., most = -1.;
    for (const auto &slave : pair.slave_faces)
      for (const double rise : slave.face.rise)
        {
          least = std::min(least, rise);
          most  = std::max(most, rise);
        }
    const auto rounded = [](const double value) { // without a sign of zero
      return std::round(1e4 * value) / 1e4 + 0.;
    };
    std::ostringstream text;
    text << std::fixed << std::setprecision(4)
         << rounded(Utilities::MPI::min(least, MPI_COMM_WORLD)) << " to "
         << rounded(Utilities::MPI::max(most, MPI_COMM_WORLD));
    print("slave opposite " + title + ": " +
          (Utilities::MPI::max(most, MPI_COMM_WORLD) == -1. ? "its facets"
                                                            : text.str()));
  }



  std::string
  percent(const double value)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << 100. * value << " %";
    return text.str();
  }



  /// Rises of the facets in 2D, by the x of their middle.
  void
  print_rises(const std::string &title, const std::string &prm)
  {
    std::map<double, double> rises;
    for_all_faces<2>(prm, [&](const auto &face, const auto &nodes) {
      rises[0.5 * (nodes[0][0] + nodes[1][0])] = rise_at(face, Point<1>(0.5));
    });
    std::map<double, double> all;
    for (const auto &of_rank : Utilities::MPI::all_gather(
           MPI_COMM_WORLD,
           std::vector<std::pair<double, double>>(rises.begin(), rises.end())))
      all.insert(of_rank.begin(), of_rank.end());
    std::ostringstream text;
    text << title << ":" << std::fixed << std::setprecision(4);
    for (const auto &[x, rise] : all)
      text << " " << (std::abs(rise) < 5e-5 ? 0. : rise);
    print(text.str());
  }



  /// Differences of the rise along xi against its gradient.
  template <int dim>
  void
  check_gradient(const std::string &title, const std::string &prm)
  {
    double error = 0.;
    for_all_faces<dim>(prm, [&](const auto &face, const auto &) {
      constexpr double h = 1e-5;
      Point<dim - 1>   xi;
      xi[0]       = 0.3;
      xi[dim - 2] = 0.25;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          Point<dim - 1> step;
          step[d]            = h;
          const double slope = (rise_at<dim>(face, xi + step) -
                                rise_at<dim>(face, Point<dim - 1>(xi - step))) /
                               (2. * h);
          error = std::max(error, std::abs(slope - rise_gradient(face, xi)[d]));
        }
    });
    print(title + ": gradient", error < 1e-8);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const auto circle = [](const Tensor<1, 2> &x) { return x.norm() - 2.; };
  const auto sphere = [](const Tensor<1, 3> &x) { return x.norm() - 2.; };
  const auto tube   = [](const Tensor<1, 3> &x) {
    return std::hypot(x[0], x[2]) - 2.;
  };
  // outside of the body is inside of the circle
  const auto hole = [](const Tensor<1, 2> &x) { return 2. - x.norm(); };

  const std::string arc        = "(1+y)*sin(1.2*A); (1+y)*cos(1.2*A)";
  const auto        with_angle = [](std::string text, const std::string &A) {
    for (auto i = text.find('A'); i != std::string::npos; i = text.find('A'))
      text.replace(i, 1, A);
    return text;
  };
  print(
    "facets of equal size: error " +
    percent(largest_error<2>(case_with(2, "8", with_angle(arc, "x")), circle)) +
    " of the rise");
  print("from small to large ones: " +
        percent(largest_error<2>(
          case_with(2, "8", with_angle(arc, "(0.3*x+0.7*x^2)")), circle)));
  print("hole: " +
        percent(largest_error<2>(
          case_with(2, "8", "(3-y)*sin(1.2*x); -(3-y)*cos(1.2*x)"), hole)));
  const std::string cylinder = "(1+z)*sin(1.2*A); y; (1+z)*cos(1.2*A)";
  const std::string cap =
    "(1+z)*tan(0.5*x-0.2)/sqrt(tan(0.5*x-0.2)^2+tan(0.5*y-0.2)^2+1); "
    "(1+z)*tan(0.5*y-0.2)/sqrt(tan(0.5*x-0.2)^2+tan(0.5*y-0.2)^2+1); "
    "(1+z)/sqrt(tan(0.5*x-0.2)^2+tan(0.5*y-0.2)^2+1)";
  const std::string curved_3d =
    case_with(3, "8, 3", with_angle(cylinder, "(0.3*x+0.7*x^2)"));
  print("cylinder of quadrilaterals: " +
        percent(largest_error<3>(curved_3d, tube)));
  print("sphere of quadrilaterals: " +
        percent(largest_error<3>(case_with(3, "5, 4", cap), sphere)));
  // the inner surfaces of these bodies are master faces, too
  const auto outer = [](const Tensor<1, 3> &x) { return x.norm() > 1.8; };
  print("cylinder of triangles: " +
        percent(largest_error<3>(
          case_with_mesh("tube_TET4"),
          [](const Tensor<1, 3> &x) { return std::hypot(x[0], x[1]) - 2.; },
          outer)));
  print(
    "sphere of triangles: " +
    percent(
      largest_error<3>(case_with_mesh("spherical_cap_TET4"), sphere, outer)));

  // an arc of radius 2 over a chord of 1 rises by 0.0635
  print_slave_rises<2>("an arc", case_with(2, "8", with_angle(arc, "x")));
  print_slave_rises<2>(
    "an arc with a flat end",
    case_with(2,
              "8",
              "if(x<0.75,(1+y)*sin(1.2*x),(1+y)*sin(0.9)+2.4*(x-0.75)*"
              "cos(0.9)); if(x<0.75,(1+y)*cos(1.2*x),(1+y)*cos(0.9)-2.4*"
              "(x-0.75)*sin(0.9))"));
  print_slave_rises<2>("a flat side", case_with(2, "8", "x; y"));
  print_slave_rises<3>("a cylinder", curved_3d);
  print_slave_rises<3>("a sphere", case_with(3, "5, 4", cap));
  print_slave_rises<3>("a barrel",
                       case_with(3, "8, 8", "x; y; z-0.3*x^2-0.1*y^2"));

  check_gradient<2>("lines", case_with(2, "8", with_angle(arc, "x")));
  check_gradient<3>("quadrilaterals", curved_3d);
  check_gradient<3>("triangles", case_with_mesh("spherical_cap_TET4"));

  const std::string parabola = "4*x; y-1-0.15*(4*x-2)^2";
  print_rises("parabola", case_with(2, "8", parabola));
  print_rises("its half, from a symmetry plane on",
              case_with(2, "4", "2+2*x; y-1-0.15*(2*x)^2") +
                "subsection Boundary conditions\n subsection plane\n"
                "  set Body = curved\n  set Boundary = 0\n"
                "  set Type = symmetry\n end\nend\n");

  // x from 0 to 4 is flat, then an arc of radius 1
  print_rises("flat beside a fillet",
              case_with(2,
                        "8",
                        "if(x<0.55, 8*x, 4+sin(2*(x-0.5))); "
                        "if(x<0.55, 0, cos(2*(x-0.5))-1)+y-1"));
  print_rises("the same, the flat part a single facet",
              case_with(2,
                        "5",
                        "if(x<0.1, 0, 2+sin(x-0.2)); "
                        "if(x<0.1, 0, cos(x-0.2)-1)+y-1"));
  print_rises("a single flat facet between two fillets",
              case_with(2,
                        "9",
                        "if(x<0.5, -1+sin(2*(x-4/9)), 1+sin(2*(x-5/9))); "
                        "if(x<0.5, cos(2*(x-4/9)), cos(2*(x-5/9)))+y-2"));
  print_rises("chamfer of 30 degrees of one facet",
              case_with(2, "3", "3*x; y-1+if(x>0.5, -0.57735, 0)"));
  print_rises("chamfer at an end",
              case_with(2, "4", "4*x; y-1+if(x>0.8, -0.2, 0)"));
  print_rises("wave", case_with(2, "12", "12*x; y-1+0.2*sin(pi/3*12*x)"));
  print_rises("polygon of ten",
              case_with(2, "4", "(1+y)*sin(pi/5*4*x); (1+y)*cos(pi/5*4*x)"));
  print_rises("polygon of eight",
              case_with(2, "4", "(1+y)*sin(pi/4*4*x); (1+y)*cos(pi/4*4*x)"));
}
