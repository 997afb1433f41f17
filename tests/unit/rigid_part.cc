// The rigid part of displacements of bodies: rotations in the mean, and motions
// that nothing resists taken out.

#include <stickslip/problem/rigid_part.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>

#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "case_problem.h"
#include "print.h"

namespace
{
  /// A finite rotation about the origin, then a translation.
  class RigidMotionField : public Function<2>
  {
  public:
    RigidMotionField(const double angle, const Point<2> &translation)
      : Function<2>(2)
      , angle(angle)
      , translation(translation)
    {}

    double
    value(const Point<2> &X, const unsigned int component) const override
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return (component == 0 ? c * X[0] - s * X[1] : s * X[0] + c * X[1]) -
             X[component] + translation[component];
    }

  private:
    const double   angle;
    const Point<2> translation;
  };



  /// Largest component at the vertices of owned cells above or below y = 1.
  double
  largest_in(const DofLayout<2> &dofs, const LA::Vector &u, const bool above)
  {
    double largest = 0.;
    for (const auto &cell : dofs.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && (cell->center()[1] > 1.) == above)
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int d = 0; d < 2; ++d)
            largest =
              std::max(largest, std::abs(u(cell->vertex_dof_index(v, d))));
    return Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ifstream file(SOURCE_DIR "/../application/data/floating_blocks.prm");
  std::ostringstream text;
  text << file.rdbuf()
       << "set Degree = 2\nsubsection Boundary conditions\n subsection held\n"
          "  set Body = lower\n  set Boundary = 2\n  set Value = 0; 0\n end\n"
          " subsection guided\n  set Body = upper\n  set Boundary = 1\n"
          "  set Value = 0; free\n end\nend\n";
  CaseProblem<2>      one(text.str());
  const DofLayout<2> &dofs    = one.problem.layout();
  const auto          motions = one.problem.free_motions();
  for (const FreeMotion &motion : motions)
    print(motion.text());

  LA::Vector u(dofs.owned, MPI_COMM_WORLD);
  LA::Vector ghosted(dofs.owned, dofs.relevant, MPI_COMM_WORLD);
  VectorTools::interpolate(dofs.mapping,
                           dofs.dof_handler,
                           RigidMotionField(0.3, Point<2>(0.2, -0.1)),
                           u);
  ghosted           = u;
  const auto angles = mean_rotations(one.mesh.bodies, dofs, ghosted);
  for (unsigned int body = 0; body < 2; ++body)
    print("rotation of body " + std::to_string(body) + " is 0.3",
          std::abs(angles[body] - 0.3) < 1e-12);

  VectorTools::interpolate(dofs.mapping,
                           dofs.dof_handler,
                           RigidMotionField(0., Point<2>(0.2, -0.1)),
                           u);
  remove_motions(motions, one.mesh.bodies, dofs, u);
  ghosted = u;
  print("the held body keeps its displacement",
        std::abs(largest_in(dofs, ghosted, false) - 0.2) < 1e-12);
  print("the guided one what is held",
        std::abs(largest_in(dofs, ghosted, true) - 0.2) < 1e-12);
  for (const bool above : {false, true})
    {
      LA::Vector x(u);
      VectorTools::interpolate(dofs.mapping,
                               dofs.dof_handler,
                               RigidMotionField(0., Point<2>(0.2, 0.)),
                               x);
      x -= u;
      ghosted = x;
      print(above ? "... and no more" : "the held one the rest, too",
            std::abs(largest_in(dofs, ghosted, above) - (above ? 0. : 0.1)) <
              1e-12);
    }
}
