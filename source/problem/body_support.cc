#include <stickslip/problem/body_support.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Numbers of groups, one per body: the same for bodies that contact pairs
    /// join.
    template <int dim>
    std::vector<unsigned int>
    groups_joined_by_contact(
      const Bodies                                         &bodies,
      const std::vector<std::unique_ptr<ContactPair<dim>>> &pairs)
    {
      std::vector<unsigned int> group(bodies.n_bodies());
      std::iota(group.begin(), group.end(), 0U);
      for (const auto &pair : pairs)
        {
          std::set<unsigned int> joined;
          for (unsigned int b = 0; b < group.size(); ++b)
            if (pair->parameters.involves(bodies.bodies[b].name))
              joined.insert(group[b]);
          for (unsigned int &g : group)
            if (joined.count(g) > 0)
              g = *joined.begin();
        }
      const std::set<unsigned int> numbers(group.begin(), group.end());
      for (unsigned int &g : group)
        g = std::distance(numbers.begin(), numbers.find(g));
      return group;
    }



    void
    refuse(const std::string &what, const std::vector<std::string> &motions)
    {
      if (motions.empty())
        return;
      std::string text = what + ":";
      for (const std::string &motion : motions)
        text += "\n  " + motion;
      throw UserError(text +
                      "\nAdd a condition in section 'Boundary conditions'.");
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
    std::vector<std::string> texts;
    for (const FreeMotion &motion :
         free_rigid_motions(conditions, bodies, dofs.mapping, dofs.dof_handler))
      {
        bool may_be_held_by_contact = false;
        for (const auto &pair : pairs)
          if (pair->parameters.involves(motion.body) &&
              pair->parameters.slave_body != pair->parameters.master_body)
            may_be_held_by_contact = pair->has_to_hold = true;
        if (!may_be_held_by_contact)
          texts.push_back(motion.text());
      }
    refuse(
      "These rigid body motions are held by no boundary condition, "
      "spring or contact pair",
      texts);
    refuse(
      "These rigid body motions are held by no boundary condition or "
      "spring; contact alone joins the bodies",
      free_motions_of_groups(conditions,
                             bodies,
                             dofs.mapping,
                             dofs.dof_handler,
                             groups_joined_by_contact(bodies, pairs)));
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
