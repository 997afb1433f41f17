// Error estimators: nothing where the solution is in the space, also with
// contact and hanging nodes; estimated over true errors for smooth solutions,
// which are known in closed form.

#include "print.h"
#include "solved_case.h"

#include <stickslip/adaptivity/linear_moduli.h>

#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// Of the solution, in the energy norm, to a known stress.
  template <int dim>
  double
  true_error(
    ContactProblem<dim>                                            &problem,
    const std::function<SymmetricTensor<2, 3>(const Point<dim> &)> &stress)
  {
    const LinearModuliOf<dim>       moduli(problem);
    std::vector<MaterialState<dim>> states;
    double                          square = 0.;
    for (const auto &cell :
         problem.layout().dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          problem.solid().evaluate_point_states(cell,
                                                problem.ghosted_displacement(),
                                                states);
          for (const auto &state : states)
            square += moduli.of(cell).square(state.cauchy_stress -
                                             stress(state.reference_position)) *
                      state.JxW;
        }
    return std::sqrt(Utilities::MPI::sum(square, MPI_COMM_WORLD));
  }



  /// mu = lambda = 1
  const std::string elastic = R"(
    subsection Materials
      subsection steel
        set Law = linear elastic
        set Young's modulus = 2.5
        set Poisson's ratio = 0.25
      end
    end
  )";



  std::string
  block(const std::string &name, const std::string &arguments)
  {
    return "subsection " + name +
           "\nset Generator = subdivided_hyper_rectangle\nset Arguments = " +
           arguments + " : true\nset Material = steel\nend\n";
  }



  std::string
  prescribed(const std::string &name,
             const std::string &body,
             const std::string &boundary,
             const std::string &type,
             const std::string &value)
  {
    return "subsection " + name + "\nset Body = " + body +
           "\nset Boundary = " + boundary + "\nset Type = " + type +
           (value.empty() ? "" : "\nset Value = " + value) + "\nend\n";
  }



  /// Two blocks under pressure, of cells that do not match, refined on both
  /// surfaces: the stress is the same everywhere.
  template <int dim>
  std::string
  patch(const unsigned int degree, const std::string &contact)
  {
    const bool        is_3d = dim == 3;
    const std::string top = is_3d ? "5" : "3", bottom = is_3d ? "4" : "2";
    const std::string value = is_3d ? "0; 0; -0.01" : "0; -0.01";
    std::string       prm   = "set Dimension = " + std::to_string(dim) +
                      "\nset Degree = " + std::to_string(degree) + "\n" +
                      elastic + "subsection Bodies\n";
    prm += is_3d ? block("upper", "3, 2, 2 : 0, 0, 1 : 1, 1, 2") +
                     block("lower", "2, 3, 2 : 0, 0, 0 : 1, 1, 1")
                 : block("upper", "3, 2 : 0, 1 : 1, 2") +
                     block("lower", "4, 2 : 0, 0 : 1, 1");
    prm +=
      "end\nsubsection Refinement\nsubsection near\nset Type = condition\n"
      "set Condition = x < 0.5 & ";
    prm += is_3d ? "abs(z - 1) < 0.3" : "abs(y - 1) < 0.3";
    prm += "\nend\nend\nsubsection Boundary conditions\n";
    for (const std::string body : {"upper", "lower"})
      for (unsigned int d = 0; d + 1 < dim; ++d)
        prm += prescribed(body + std::to_string(d),
                          body,
                          std::to_string(2 * d),
                          "symmetry",
                          "");
    prm += prescribed("foot", "lower", bottom, "symmetry", "") +
           prescribed("load", "upper", top, "traction", value) +
           "end\nsubsection Contact\nsubsection pair\nset Slave body = upper\n"
           "set Slave boundary = " +
           bottom + "\nset Master body = lower\nset Master boundary = " + top +
           "\n" + contact + "end\nend\n";
    return prm;
  }



  template <int dim>
  void
  test_patch(const unsigned int degree, const std::string &contact = "")
  {
    SolvedCase<dim> solved(patch<dim>(degree, contact));
    // the root of a gap that is roundoff is left of the contact law
    for (const std::string name : {"residual", "recovery", "Kelly"})
      print(std::to_string(dim) + "D, degree " + std::to_string(degree) + ", " +
              name + ": no error in the patch test",
            solved.estimate(name).relative() < 1e-6);
  }



  /// The true errors of meshes of which each has cells of half the size, and
  /// the estimated ones over them.
  template <int dim>
  void
  test_effectivity(
    const std::string                                              &title,
    const std::function<std::string(const unsigned int)>           &case_of,
    const unsigned int                                              n_meshes,
    const std::function<SymmetricTensor<2, 3>(const Point<dim> &)> &stress)
  {
    print(title);
    double before = 0.;
    for (unsigned int i = 0; i < n_meshes; ++i)
      {
        SolvedCase<dim>    solved(case_of(i));
        const double       error = true_error<dim>(solved.problem, stress);
        std::ostringstream text;
        text << std::setprecision(3) << "  relative error "
             << error / solved.estimate("Kelly").energy_norm;
        if (i > 0)
          text << ", order " << std::log2(before / error);
        for (const std::string name : {"residual", "recovery", "Kelly"})
          text << ", " << name << ' ' << solved.estimate(name).error / error;
        print(text.str());
        before = error;
      }
  }



  /// u = (s, s), s = sin(pi x) sin(pi y), on the unit square; tractions at
  /// x = 1.
  void
  test_square(const unsigned int degree)
  {
    const auto case_of = [degree](const unsigned int i) {
      const std::string n = std::to_string(4 << i);
      const std::string force =
        "pi^2*(4*sin(pi*x)*sin(pi*y) - 2*cos(pi*x)*cos(pi*y))";
      return "set Dimension = 2\nset Degree = " + std::to_string(degree) +
             "\n" + elastic + "subsection Bodies\n" +
             block("square", n + ", " + n + " : 0, 0 : 1, 1") +
             "end\nsubsection Boundary conditions\n" +
             prescribed("hold", "square", "0, 2, 3", "displacement", "0; 0") +
             prescribed("pull",
                        "square",
                        "1",
                        "traction",
                        "-3*pi*sin(pi*y); -pi*sin(pi*y)") +
             "subsection force\nset Body = square\nset Type = body force\n"
             "set Value = " +
             force + "; " + force + "\nend\nend\n";
    };
    const auto stress = [](const Point<2> &p) {
      const double          pi = numbers::PI;
      const double          dx = pi * std::cos(pi * p[0]) * std::sin(pi * p[1]);
      const double          dy = pi * std::sin(pi * p[0]) * std::cos(pi * p[1]);
      SymmetricTensor<2, 3> s;
      s[0][0] = dx + dy + 2. * dx;
      s[1][1] = dx + dy + 2. * dy;
      s[2][2] = dx + dy;
      s[0][1] = dx + dy;
      return s;
    };
    test_effectivity<2>("square, degree " + std::to_string(degree),
                        case_of,
                        degree == 1 ? 4 : 3,
                        stress);
  }



  /// u = (s, s, s), s = sin(pi x) sin(pi y) sin(pi z), on the unit cube.
  void
  test_cube(const unsigned int degree)
  {
    const auto case_of = [degree](const unsigned int i) {
      const std::string n  = std::to_string((degree == 1 ? 4 : 2) << i);
      const std::string s  = "5*sin(pi*x)*sin(pi*y)*sin(pi*z)";
      const std::string xy = "2*cos(pi*x)*cos(pi*y)*sin(pi*z)";
      const std::string xz = "2*cos(pi*x)*sin(pi*y)*cos(pi*z)";
      const std::string yz = "2*sin(pi*x)*cos(pi*y)*cos(pi*z)";
      const auto component = [&s](const std::string &a, const std::string &b) {
        return "pi^2*(" + s + " - " + a + " - " + b + ")";
      };
      return "set Dimension = 3\nset Degree = " + std::to_string(degree) +
             "\n" + elastic + "subsection Bodies\n" +
             block("cube", n + ", " + n + ", " + n + " : 0, 0, 0 : 1, 1, 1") +
             "end\nsubsection Boundary conditions\n" +
             prescribed("hold", "cube", "all", "displacement", "0; 0; 0") +
             "subsection force\nset Body = cube\nset Type = body force\n"
             "set Value = " +
             component(xy, xz) + "; " + component(xy, yz) + "; " +
             component(xz, yz) + "\nend\nend\n";
    };
    const auto stress = [](const Point<3> &p) {
      Tensor<1, 3> d; // of s
      for (unsigned int c = 0; c < 3; ++c)
        {
          d[c] = numbers::PI;
          for (unsigned int e = 0; e < 3; ++e)
            d[c] *= e == c ? std::cos(numbers::PI * p[e])
                           : std::sin(numbers::PI * p[e]);
        }
      SymmetricTensor<2, 3> s;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          s[i][j] = d[i] + d[j] + (i == j ? d[0] + d[1] + d[2] : 0.);
      return s;
    };
    test_effectivity<3>("cube, degree " + std::to_string(degree),
                        case_of,
                        3,
                        stress);
  }



  /// A tube of radii 1 and 2 under an inner pressure of 1 (Lame).
  void
  test_tube(const unsigned int degree)
  {
    const auto case_of = [degree](const unsigned int i) {
      return "set Dimension = 2\nset Degree = " + std::to_string(degree) +
             "\n" + elastic +
             "subsection Bodies\nsubsection tube\n"
             "set Generator = quarter_hyper_shell\n"
             "set Arguments = 0, 0 : 1 : 2 : 2 : true\n"
             "set Material = steel\nend\nend\n"
             "subsection Mesh\nset Global refinements = " +
             std::to_string(i + 1) + "\nend\n" +
             "subsection Boundary conditions\n" +
             prescribed("left", "tube", "2", "symmetry", "") +
             prescribed("right", "tube", "3", "symmetry", "") +
             prescribed("press", "tube", "0", "pressure", "1") + "end\n";
    };
    const auto stress = [](const Point<2> &p) {
      const double          A = 1. / 3., B = 4. / 3.;
      const double          r = p.norm();
      const Tensor<1, 2>    e = p / r;
      SymmetricTensor<2, 3> s;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = i; j < 2; ++j)
          s[i][j] =
            (i == j ? A + B / (r * r) : 0.) - 2. * B / (r * r) * e[i] * e[j];
      s[2][2] = 0.25 * 2. * A;
      return s;
    };
    test_effectivity<2>("tube, degree " + std::to_string(degree),
                        case_of,
                        4,
                        stress);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      test_patch<2>(degree);
      test_patch<3>(degree);
    }
  test_patch<2>(1, "set Friction = Coulomb\nset Friction coefficient = 0.3\n");
  for (const unsigned int degree : {1, 2})
    {
      test_square(degree);
      test_tube(degree);
      test_cube(degree);
    }
}
