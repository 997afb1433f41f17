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

  /// Dimensions of an annular sector; angles in degrees from the x axis.
  struct AnnularSector
  {
    double       inner_radius;
    double       outer_radius;
    double       first_angle;
    double       last_angle;
    unsigned int n_radial;
    unsigned int n_angular;
    double       length  = 1.; ///< 3D: extruded from z = 0 to z = length
    unsigned int n_axial = 1;
  };

  /**
   * Part of a ring (2D) or of a pipe's wall (3D, axis z), around the origin.
   * Boundary ids: 0 inner, 1 outer, 2 at the first angle, 3 at the last angle
   * (neither if the ring is closed), 4 at z = 0, 5 at z = length. All cells
   * have manifold 0: spherical in 2D, cylindrical in 3D.
   */
  template <int dim>
  void
  make_annular_sector(const AnnularSector &sector,
                      Triangulation<dim>  &triangulation);
} // namespace stickslip

#endif
