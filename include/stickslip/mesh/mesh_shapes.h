#ifndef stickslip_mesh_mesh_shapes_h
#define stickslip_mesh_mesh_shapes_h

#include <deal.II/grid/tria.h>

#include <array>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * Rectangle or box with its own division positions in each direction
   * (increasing, at least two). Boundary ids 0, 1 (x), 2, 3 (y), 4, 5 (z) as
   * deal.II's colorized hyper_rectangle.
   */
  template <int dim>
  void
  make_graded_hyper_rectangle(
    const std::array<std::vector<double>, dim> &positions,
    Triangulation<dim>                         &triangulation);

  /// Division positions (increasing, at least two) of an annular sector.
  struct AnnularSector
  {
    std::vector<double> radii;
    std::vector<double> angles;  ///< in degrees from the x axis
    std::vector<double> heights; ///< along z; not used in 2D
  };

  /**
   * Part of a ring (2D) or of a pipe's wall (3D, axis z), around the origin.
   * Boundary ids: 0 inner, 1 outer, 2 at the first angle, 3 at the last angle
   * (neither if the ring is closed), 4 at the first height, 5 at the last one.
   * All cells have manifold 0: spherical in 2D, cylindrical in 3D.
   */
  template <int dim>
  void
  make_annular_sector(const AnnularSector &sector,
                      Triangulation<dim>  &triangulation);
} // namespace stickslip

#endif
