// The symmetry planes that a node of a surface lies on, from its supports.

#include "print.h"

#include <stickslip/contact/pairing/symmetry_planes.h>

#include <sstream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  // The projections of e_x, e_y, e_z for the middle node of a strip or a square
  // of facets (the node is at the origin), with the dofs of it that `lines`
  // holds.
  template <int dim>
  void
  print_projection(const std::string             &text,
                   const std::vector<Point<dim>> &others,
                   const Constraints             &supports)
  {
    std::vector<Point<dim>> positions = others;
    positions.emplace_back();
    const unsigned int own = others.size();
    const auto         P   = symmetry_projection<dim>(
      positions, own, own * dim, unit_symmetric_tensor<dim>(), supports);
    print(text + ":");
    for (unsigned int c = 0; c < dim; ++c)
      {
        std::ostringstream row;
        for (unsigned int d = 0; d < dim; ++d)
          row << ' ' << P[c][d];
        print("   " + row.str());
      }
  }



  // Supports of the node with the dofs first, first + 1, ...
  Constraints
  hold(const types::global_dof_index    first,
       const std::vector<unsigned int> &components)
  {
    Constraints lines;
    for (const unsigned int c : components)
      lines.add_line(first + c);
    lines.close();
    return lines;
  }
} // namespace

int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::vector<Point<2>>      right{Point<2>(1., 0.2)},
    both{Point<2>(1., 0.2), Point<2>(-1., 0.2)};
  print_projection<2>("2D, free", right, hold(2, {}));
  print_projection<2>("2D, at the border, u_x = 0", right, hold(2, {0}));
  print_projection<2>("2D, clamped", right, hold(2, {0, 1}));
  print_projection<2>("2D, in the middle, u_x = 0", both, hold(4, {0}));

  const Point<3> a(1, 0, 0.1), b(0, 1, 0.1), c(1, 1, 0.2), d(-1, 0, 0.1),
    e(-1, 1, 0.2);
  const std::vector<Point<3>> quarter{a, b, c}, half{a, b, c, d, e};
  print_projection<3>("3D, corner, u_x = u_y = 0", quarter, hold(9, {0, 1}));
  print_projection<3>("3D, edge y = 0, u_x = u_y = 0", half, hold(15, {0, 1}));

  // u_x = u_y: the plane x = y, one side of which is the surface
  Constraints inclined;
  inclined.add_line(9);
  inclined.add_entry(9, 10, 1.);
  inclined.close();
  print_projection<3>("3D, u_x = u_y at the border",
                      {a, c, Point<3>(1, -1, 0.)},
                      inclined);
  print_projection<3>("3D, u_x = u_y with facets on both sides",
                      quarter,
                      inclined);
}
