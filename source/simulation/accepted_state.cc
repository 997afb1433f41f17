#include <stickslip/simulation/accepted_state.h>

namespace stickslip
{
  template <int dim>
  AcceptedState
  AcceptedState::zero(const ContactProblem<dim> &problem)
  {
    const LA::BlockVector x = problem.zero_state();
    return {x, x.block(0), x.block(0), x.block(0)};
  }



  template <int dim>
  LA::Vector
  AcceptedState::advance(const LA::BlockVector &x_new,
                         ContactProblem<dim>   &problem,
                         WorkBalance           &work)
  {
    LA::Vector step(x_new.block(0));
    step -= x.block(0);
    work.external +=
      0.5 * (nodal_forces * step + problem.nodal_forces() * step);
    work.stabilization +=
      problem.solid().stabilization_work(problem.ghosted_displacement());
    work.contact +=
      0.5 * (contact_forces * step + problem.contact_forces() * step);
    nodal_forces   = problem.nodal_forces();
    contact_forces = problem.contact_forces();
    x              = x_new;
    return step;
  }

#define INSTANTIATE(dim)                                                   \
  template AcceptedState AcceptedState::zero(const ContactProblem<dim> &); \
  template LA::Vector    AcceptedState::advance(const LA::BlockVector &,   \
                                             ContactProblem<dim> &,     \
                                             WorkBalance &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
