#ifndef stickslip_mesh_axis_of_revolution_h
#define stickslip_mesh_axis_of_revolution_h

#include <stickslip/mesh/body.h>

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Makes bodies of revolution of the @p bodies, whose mesh is complete: sets
   * their cross section, and which of them reach the axis. Throws UserError, on
   * all ranks, if one has a negative radius. Collective.
   */
  template <int dim>
  void
  revolve_bodies(const Triangulation<dim> &triangulation, Bodies &bodies);

  /// What the user should know of that, for the log; empty in other models.
  std::vector<std::string>
  describe_axis(const Bodies &bodies);
} // namespace stickslip

#endif
