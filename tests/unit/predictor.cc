// Where a step starts: rigid bodies are where their motion has them, exactly;
// everything else stays where it was extrapolated to.

#include "case_problem.h"
#include "print.h"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// A block, and a roller beside it that turns about its axis at (0, 3) and
  /// travels along x.
  const std::string prm =
    "set Dimension = 2\nsubsection Bodies\nsubsection block\n"
    "set Generator = subdivided_hyper_rectangle\n"
    "set Arguments = 3, 1 : -1, 0 : 1, 1 : true\nset Material = m\nend\n"
    "subsection roller\nset Generator = annular_sector\n"
    "set Arguments = 0.5 : 1 : 0 : 360 : 1 : 12\nset Translation = 0, 3\n"
    "set Rigid = true\nend\nend\n"
    "subsection Materials\nsubsection m\nset Law = linear elastic\n"
    "set Young's modulus = 10\nend\nend\n"
    "subsection Boundary conditions\nsubsection bottom\nset Body = block\n"
    "set Boundary = 2\nset Value = 0; t\nend\nsubsection roll\n"
    "set Body = roller\nset Type = rigid motion\nset Translation = 2*t; 0\n"
    "set Rotation centre = 0, 3\nset Rotation angle = 90*t\nend\nend\n";
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  CaseProblem<2>  rolling(prm);
  auto           &problem = rolling.problem;
  const IndexSet &owned   = problem.layout().owned;
  problem.begin_step(1., problem.zero_state());
  // extrapolated: the roller along its tangents, the block by 0.25
  LA::BlockVector predicted = problem.zero_state();
  predicted.block(0)        = 0.25;
  problem.place_rigid_bodies(predicted.block(0));

  std::map<types::global_dof_index, Point<2>> position;
  DoFTools::map_dofs_to_support_points(problem.layout().mapping,
                                       problem.layout().dof_handler,
                                       position);
  double largest_error = 0., largest_change = 0.;
  for (const auto &cell : problem.layout().dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        std::vector<types::global_dof_index> dofs(8);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < 8; ++i)
          if (owned.is_element(dofs[i]))
            {
              const Point<2> X = position[dofs[i]];
              const double   u = predicted.block(0)(dofs[i]);
              // a quarter of a turn takes (x, 3 + y) to (-y, 3 + x)
              const double exact =
                i % 2 == 0 ? 2. - (X[1] - 3.) - X[0] : 3. + X[0] - X[1];
              if (X[1] > 1.5)
                largest_error = std::max(largest_error, std::abs(u - exact));
              else
                largest_change = std::max(largest_change, std::abs(u - 0.25));
            }
      }
  print("the roller has turned and travelled", largest_error < 1e-12);
  print("the block is where it was", largest_change == 0.);
  // the bottom of the block still lacks 0.75
  print("what is prescribed to the block is not applied",
        std::abs(problem.unapplied_displacement(predicted) - 0.75) < 1e-12);
}
