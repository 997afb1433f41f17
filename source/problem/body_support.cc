#include <stickslip/problem/body_support.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <set>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Numbers of groups, one per body: the same for bodies that contact pairs
    /// or cuts join.
    template <int dim>
    std::vector<unsigned int>
    groups_joined_by_contact(
      const BoundaryConditions<dim>                        &conditions,
      const Bodies                                         &bodies,
      const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs)
    {
      std::vector<unsigned int> group =
        groups_joined_by_cuts(conditions, bodies);
      for (const auto &pair : pairs)
        {
          std::set<unsigned int> joined;
          for (unsigned int b = 0; b < group.size(); ++b)
            if (pair->parameters.involves(bodies.bodies[b].name))
              joined.insert(group[b]);
          join_groups(joined, group);
        }
      number_groups(group);
      return group;
    }



    void
    refuse(const std::string &what, const std::vector<FreeMotion> &motions)
    {
      if (motions.empty())
        return;
      std::string text = what + ":";
      for (const FreeMotion &motion : motions)
        text += "\n  " + motion.text();
      throw UserError(text +
                      "\nAdd a condition in section 'Boundary conditions'.");
    }

    /// Both parts of a bolt need something that they can pull at.
    template <int dim>
    void
    check_bolts_carry(
      const BoundaryConditions<dim>                        &conditions,
      const Bodies                                         &bodies,
      const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs)
    {
      for (const auto &bolt : conditions.pretensions())
        for (const auto &side : bolt.sides)
          {
            const std::string &name    = bodies.bodies[side.body].name;
            const auto         is_here = [&](const auto &condition) {
              return condition.body == side.body;
            };
            const auto &displacements = conditions.prescribed_displacements();
            const auto &loads         = conditions.loads();
            const bool  carries =
              std::any_of(pairs.begin(),
                          pairs.end(),
                          [&](const auto &pair) {
                            return pair->parameters.involves(name);
                          }) ||
              std::any_of(displacements.begin(),
                          displacements.end(),
                          is_here) ||
              std::any_of(loads.begin(), loads.end(), is_here);
            if (!carries && bolt.sides[0].body != bolt.sides[1].body)
              throw UserError("Boundary conditions/" + bolt.name + ": body '" +
                              name +
                              "' has neither contact nor another condition. "
                              "Both parts of a bolt have to be held.");
          }
    }
  } // namespace



  template <int dim>
  void
  check_bodies_are_held(
    const BoundaryConditions<dim>                        &conditions,
    const Bodies                                         &bodies,
    const DofLayout<dim>                                 &dofs,
    const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs)
  {
    std::vector<FreeMotion> unheld;
    for (const FreeMotion &motion :
         free_rigid_motions(conditions, bodies, dofs.mapping, dofs.dof_handler))
      {
        bool may_be_held_by_contact = false;
        for (const auto &pair : pairs)
          if (motion.concerns(pair->parameters) &&
              pair->parameters.slave_body != pair->parameters.master_body)
            may_be_held_by_contact = pair->has_to_hold = true;
        if (!may_be_held_by_contact)
          unheld.push_back(motion);
      }
    refuse(
      "These rigid body motions are held by no boundary condition, "
      "spring or contact pair",
      unheld);
    check_bolts_carry(conditions, bodies, pairs);
    refuse(
      "These rigid body motions are held by no boundary condition or "
      "spring; contact alone joins the bodies",
      free_motions_of_groups(
        conditions,
        bodies,
        dofs.mapping,
        dofs.dof_handler,
        groups_joined_by_contact(conditions, bodies, pairs)));
  }



  template <int dim>
  std::vector<FreeMotion>
  weakly_held_motions(const BoundaryConditions<dim> &conditions,
                      const Bodies                  &bodies,
                      const DofLayout<dim>          &dofs,
                      const double                   softest_spring)
  {
    const auto free =
      free_rigid_motions(conditions, bodies, dofs.mapping, dofs.dof_handler);
    const auto is_free = [&free](const FreeMotion &motion) {
      return std::any_of(free.begin(),
                         free.end(),
                         [&motion](const FreeMotion &other) {
                           return other.text() == motion.text();
                         });
    };
    std::vector<FreeMotion> motions = free_rigid_motions(
      conditions, bodies, dofs.mapping, dofs.dof_handler, softest_spring);
    motions.erase(std::remove_if(motions.begin(), motions.end(), is_free),
                  motions.end());
    return motions;
  }

#define INSTANTIATE(dim)                                     \
  template void check_bodies_are_held(                       \
    const BoundaryConditions<dim> &,                         \
    const Bodies &,                                          \
    const DofLayout<dim> &,                                  \
    const std::vector<std::unique_ptr<ContactPair<dim>>> &); \
  template std::vector<FreeMotion> weakly_held_motions(      \
    const BoundaryConditions<dim> &,                         \
    const Bodies &,                                          \
    const DofLayout<dim> &,                                  \
    const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
