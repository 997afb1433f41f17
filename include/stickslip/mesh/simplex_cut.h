#ifndef stickslip_mesh_simplex_cut_h
#define stickslip_mesh_simplex_cut_h

#include <deal.II/grid/tria.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /// What cut_into_simplices() makes of a quadrilateral or hexahedron.
  constexpr double
  n_simplices_per_cell(const int dim)
  {
    return dim == 2 ? 8. : 24.;
  }

  /// Replaces the active cells of a serial mesh by triangles or tetrahedra with
  /// vertices in the middles of faces and cells, on the manifolds of these.
  /// Boundary, material and manifold ids stay. Throws UserError that blames
  /// @p path, the body's subsection, if they are simplices already.
  template <int dim>
  void
  cut_into_simplices(const std::string  &path,
                     Triangulation<dim> &triangulation);
} // namespace stickslip

#endif
