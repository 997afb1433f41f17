#include <stickslip/simulation/run_state.h>

#include <stickslip/base/no_convergence.h>

#include <stickslip/adaptivity/state_transfer.h>

#include <stickslip/contact/results/contact_results.h>

#include <stickslip/output/contact_resultants.h>

#include <stickslip/problem/rigid_part.h>

namespace stickslip
{
  template <int dim>
  RunState<dim>::RunState(const CaseParameters &parameters,
                          Mesh<dim>            &mesh,
                          ConvergenceLog       &log,
                          const StopRequests   &stop_requests)
    : parameters(parameters)
    , amplitudes(
        parameters.make_amplitudes(mesh.triangulation->get_communicator()))
    , mesh(mesh)
    , log(log)
    , stop_requests(stop_requests)
  {
    discretize();
  }



  template <int dim>
  void
  RunState<dim>::discretize()
  {
    discretization.reset(); // two at a time would need twice the memory
    discretization = std::make_unique<Discretization<dim>>(
      parameters, amplitudes, mesh, log, stop_requests);
    accepted = AcceptedState::zero(problem());
    // moved: a copy would keep the earlier distribution over the ranks where
    // the number of unknowns happens to be the same
    x = LA::BlockVector(accepted.x);
  }



  template <int dim>
  std::vector<bool>
  RunState<dim>::closed_pairs() const
  {
    std::vector<bool> closed;
    for (const auto &pair :
         compute_contact_resultants(contact_results(problem().contact()),
                                    parameters.contact_pairs.size(),
                                    mesh.triangulation->get_communicator(),
                                    mesh.bodies.cross_section))
      closed.push_back(pair.n_closed() > 0);
    return closed;
  }



  template <int dim>
  void
  RunState<dim>::begin_step(const double time)
  {
    step_solver().begin_step();
    if (!parameters.load_stepping.locates_contact_changes)
      return;
    problem().begin_step(time, accepted.x);
    problem().configure(accepted.x, true);
    closed_before = closed_pairs();
  }



  template <int dim>
  LA::BlockVector
  RunState<dim>::predict(const double size) const
  {
    if (x_is_guess)
      return x;
    LA::BlockVector predicted(accepted.x);
    predicted.block(0).add(size, accepted.rate);
    return predicted;
  }



  template <int dim>
  void
  RunState<dim>::accept_step(const double size)
  {
    problem().accept_step(x);
    accepted.rate = accepted.advance(x, problem(), work);
    accepted.rate *= 1. / size;
    x_is_guess = false;
  }



  template <int dim>
  void
  RunState<dim>::forget_motions(const std::vector<FreeMotion> &motions)
  {
    if (!motions.empty())
      remove_motions(motions, mesh.bodies, problem().layout(), accepted.rate);
  }



  template <int dim>
  void
  RunState<dim>::restore()
  {
    problem().restore();
    x          = accepted.x;
    x_is_guess = false;
  }



  template <int dim>
  double
  RunState<dim>::adapt_mesh(const double time, MeshAdaptation<dim> &adaptation)
  {
    StateTransfer<dim> transfer(problem(),
                                time,
                                {accepted.x, accepted.rate, x},
                                adaptation.indicators());
    discretization.reset();
    do
      transfer.execute(adaptation.triangulation());
    while (adaptation.expects_finer(transfer.expected_indicators()));
    discretize();
    step_solver().begin_on_other_mesh();
    const MeshState state     = transfer.put_into(problem(), time);
    const double    imbalance = problem().residual(state.x).equilibrium;
    accepted.x                = state.x;
    accepted.rate             = state.rate;
    accepted.nodal_forces     = problem().nodal_forces();
    accepted.contact_forces   = problem().contact_forces();
    x                         = state.guess;
    return imbalance;
  }



  template <int dim>
  unsigned int
  RunState<dim>::find_equilibrium(const double       time,
                                  const StepControl &step_control)
  {
    const LA::BlockVector guess      = x;
    const bool            has_guess  = x_is_guess;
    const auto            keep_guess = [&]() {
      x_is_guess = has_guess;
      if (!has_guess)
        return;
      x = guess;
      step_solver().begin_on_other_mesh();
    };
    problem().solid().stabilization().begin_step(
      step_control.steps().step_size());
    step_solver().begin_step();
    try
      {
        step_solver().solve(time, accepted.x, accepted.x, step_control, x);
      }
    catch (const NoConvergence &)
      {
        restore();
        keep_guess();
        throw;
      }
    const unsigned int iterations = problem().counts.newton_iterations;
    problem().accept_step(x);
    accepted.advance(x, problem(), work);
    keep_guess();
    return iterations;
  }

  template class RunState<2>;
  template class RunState<3>;
} // namespace stickslip
