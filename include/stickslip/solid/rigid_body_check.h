#ifndef stickslip_solid_rigid_body_check_h
#define stickslip_solid_rigid_body_check_h

#include <stickslip/solid/boundary_conditions.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /// A rigid motion of a body, or of some that are joined, that no boundary
  /// condition prevents.
  struct FreeMotion
  {
    std::vector<std::string> bodies; ///< their names
    std::string              motion; ///< "rotation about z", for messages only

    /// Factors of rigid_mode() about a centre [its first dim coordinates].
    std::vector<double> factors, centre;

    /// For messages: "body 'punch': rotation about z".
    std::string
    text() const;

    /// Whether a contact pair is at one of the bodies.
    template <typename PairParameters>
    bool
    concerns(const PairParameters &pair) const
    {
      return std::any_of(bodies.begin(),
                         bodies.end(),
                         [&pair](const std::string &body) {
                           return pair.involves(body);
                         });
    }
  };

  /// A line for each group of bodies that @p motions, which contact alone can
  /// prevent, are of.
  std::vector<std::string>
  describe(const std::vector<FreeMotion> &motions);

  /**
   * The rigid motions of the bodies, rigid ones only if their motion has free
   * components, that no prescribed displacement, spring or periodicity
   * prevents: translations, and rotations about the body's centre, combined
   * with a translation if it is supported elsewhere. Bodies on both sides of a
   * cut (pretension) move as one. Contact is not considered,
   * and springs count from the stiffness (force per
   * area and length) @p softest_spring on. Collective; the same on all ranks.
   */
  template <int dim>
  std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<dim>    &conditions,
                     const Bodies                     &bodies,
                     const hp::MappingCollection<dim> &mapping,
                     const DoFHandler<dim>            &dof_handler,
                     const double                      softest_spring = 0.);

  /**
   * The same of groups of bodies that move as one: @p group_of_body gives the
   * group's number for each body, from zero on without a gap. Groups with a
   * rigid body whose motion is prescribed are held. Collective; the same on all
   * ranks.
   */
  template <int dim>
  std::vector<FreeMotion>
  free_motions_of_groups(const BoundaryConditions<dim>    &conditions,
                         const Bodies                     &bodies,
                         const hp::MappingCollection<dim> &mapping,
                         const DoFHandler<dim>            &dof_handler,
                         const std::vector<unsigned int>  &group_of_body,
                         const double                      softest_spring = 0.);

  /// Numbers of groups, one per body: the same for bodies that cuts join.
  template <int dim>
  std::vector<unsigned int>
  groups_joined_by_cuts(const BoundaryConditions<dim> &conditions,
                        const Bodies                  &bodies);

  /// Makes one group of all @p joined ones, in the numbers of the bodies'
  /// groups.
  void
  join_groups(const std::set<unsigned int> &joined,
              std::vector<unsigned int>    &group_of_body);

  /// Numbers the groups from zero on without a gap.
  void
  number_groups(std::vector<unsigned int> &group_of_body);
} // namespace stickslip

#endif
