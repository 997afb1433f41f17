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
   * The rigid motions of the bodies, rigid ones only if their motion has free
   * components, that no prescribed displacement, spring or periodicity
   * prevents: translations, and rotations about the body's centre, combined
   * with a translation if it is supported elsewhere. Contact is not considered,
   * and springs count from the stiffness (force per
   * area and length) @p softest_spring on. Collective; the same on all ranks.
   */
  template <int dim>
  std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<dim> &conditions,
                     const Bodies                  &bodies,
                     const Mapping<dim>            &mapping,
                     const DoFHandler<dim>         &dof_handler,
                     const double                   softest_spring = 0.);

  /**
   * The same of groups of bodies that move as one: @p group_of_body gives the
   * group's number for each body. Groups with a rigid body whose motion is
   * prescribed are held. Texts such
   * as "bodies 'a', 'b': translation along x". Collective; the same on all
   * ranks.
   */
  template <int dim>
  std::vector<std::string>
  free_motions_of_groups(const BoundaryConditions<dim>   &conditions,
                         const Bodies                    &bodies,
                         const Mapping<dim>              &mapping,
                         const DoFHandler<dim>           &dof_handler,
                         const std::vector<unsigned int> &group_of_body);
} // namespace stickslip

#endif
