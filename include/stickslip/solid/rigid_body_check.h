#ifndef stickslip_solid_rigid_body_check_h
#define stickslip_solid_rigid_body_check_h

#include <stickslip/solid/boundary_conditions.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// A rigid motion of a body that no boundary condition prevents.
  struct FreeMotion
  {
    std::string body;   ///< its name
    std::string motion; ///< "rotation about z", for messages only

    /// For messages: "body 'punch': rotation about z".
    std::string
    text() const
    {
      return "body '" + body + "': " + motion;
    }
  };

  /**
   * The rigid motions of the deformable bodies that no prescribed displacement,
   * spring or periodicity prevents: translations, and rotations about the
   * body's centre, combined with a translation if it is supported elsewhere.
   * Contact is not considered. Collective; the same on all ranks.
   */
  template <int dim>
  std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<dim> &conditions,
                     const Bodies                  &bodies,
                     const Mapping<dim>            &mapping,
                     const DoFHandler<dim>         &dof_handler);
} // namespace stickslip

#endif
