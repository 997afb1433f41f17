#include <stickslip/solid/rigid_body_conditions.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <string>

namespace stickslip
{
  template <int dim>
  bool
  has_coupling(const std::vector<PrescribedDisplacement<dim>> &conditions,
               const unsigned int                              body)
  {
    return std::any_of(conditions.begin(),
                       conditions.end(),
                       [body](const auto &condition) {
                         return condition.body == body &&
                                condition.is_coupling();
                       });
  }



  template <int dim>
  void
  check_couplings_of_rigid_bodies(
    const std::vector<PrescribedDisplacement<dim>> &conditions,
    const Bodies                                   &bodies)
  {
    for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
      {
        if (!bodies.bodies[b].is_rigid || !has_coupling(conditions, b))
          continue;
        std::vector<std::string> paths;
        for (const PrescribedDisplacement<dim> &condition : conditions)
          if (condition.body == b)
            paths.push_back("'Boundary conditions/" + condition.name + "'");
        if (paths.size() > 1)
          throw UserError(paths[0] + " and " + paths[1] + ": body '" +
                          bodies.bodies[b].name +
                          "' is rigid and has a motion with free components. "
                          "It takes one condition.");
      }
  }



  template <int dim>
  std::vector<PrescribedDisplacement<dim>>
  holds_of_idle_rigid_bodies(
    const std::vector<PrescribedDisplacement<dim>> &conditions,
    const Bodies                                   &bodies)
  {
    std::vector<bool> moves(bodies.n_bodies(), false);
    for (const PrescribedDisplacement<dim> &condition : conditions)
      moves[condition.body] = true;

    std::vector<PrescribedDisplacement<dim>> result;
    for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
      if (bodies.bodies[b].is_rigid && !moves[b])
        {
          PrescribedDisplacement<dim> condition;
          condition.name = "(rigid body " + bodies.bodies[b].name + ")";
          condition.type = BoundaryConditionType::rigid_motion;
          condition.body = b;
          result.push_back(condition);
        }
    return result;
  }

#define INSTANTIATE(dim)                                                       \
  template bool has_coupling(const std::vector<PrescribedDisplacement<dim>> &, \
                             const unsigned int);                              \
  template void check_couplings_of_rigid_bodies(                               \
    const std::vector<PrescribedDisplacement<dim>> &, const Bodies &);         \
  template std::vector<PrescribedDisplacement<dim>>                            \
  holds_of_idle_rigid_bodies(const std::vector<PrescribedDisplacement<dim>> &, \
                             const Bodies &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
