#ifndef stickslip_simulation_run_state_h
#define stickslip_simulation_run_state_h

#include <stickslip/base/amplitude.h>

#include <stickslip/simulation/accepted_state.h>
#include <stickslip/simulation/discretization.h>
#include <stickslip/simulation/mesh_adaptation.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /// Where a run is: its mesh, the last accepted state on it, the present
  /// iterate. All functions are collective.
  template <int dim>
  class RunState
  {
  public:
    /// The state zero on @p mesh. The arguments must outlive this object. Throws
    /// UserError.
    RunState(const CaseParameters &parameters,
             Mesh<dim>            &mesh,
             ConvergenceLog       &log,
             const StopRequests   &stop_requests);

    ContactProblem<dim> &
    problem() const
    {
      return discretization->problem;
    }

    StepSolver<dim> &
    step_solver() const
    {
      return discretization->step_solver;
    }

    /// A step begins at load time @p time. Collective.
    void
    begin_step(const double time);

    /// Whether a contact pair is closed in the present iterate, which has just
    /// been found, that was open in the accepted state, or the other way. Only
    /// with 'Locate contact changes'. Collective.
    bool
    contact_changes() const
    {
      return closed_pairs() != closed_before;
    }

    /// Where a step of @p size may lead: goes on from the accepted state as in
    /// the last step, or to what repeat_step() has kept.
    LA::BlockVector
    predict(const double size) const;

    /// The present iterate is accepted, after a step of @p size.
    void
    accept_step(const double size);

    /// The next step is not predicted to go on with @p motions, which nothing
    /// resists: it would do so for ever.
    void
    forget_motions(const std::vector<FreeMotion> &motions);

    /// Back to the accepted state.
    void
    restore();

    /// The step that has led to the present iterate will be solved once more,
    /// which begins there.
    void
    repeat_step()
    {
      problem().restore();
      x_is_guess = true;
    }

    /// The cells of the mesh are others: begins anew on them.
    void
    discretize();

    /// Refines and coarsens the cells that @p adaptation has flagged, further
    /// as long as it wants to, and carries the accepted state of load time
    /// @p time and the present iterate over. Returns the relative imbalance of
    /// the first.
    double
    adapt_mesh(const double time, MeshAdaptation<dim> &adaptation);

    /// Brings the accepted state to equilibrium under the loads of its time.
    /// Returns the Newton iterations. Throws NoConvergence; the state is then
    /// as before.
    unsigned int
    find_equilibrium(const double time, const StepControl &step_control);

    LA::BlockVector x;        ///< present state
    AcceptedState   accepted; ///< last accepted state
    WorkBalance     work;

  private:
    const CaseParameters                &parameters;
    const Amplitudes                     amplitudes;
    Mesh<dim>                           &mesh;
    ConvergenceLog                      &log;
    const StopRequests                  &stop_requests;
    std::unique_ptr<Discretization<dim>> discretization;
    bool                                 x_is_guess = false;
    std::vector<bool> closed_before; ///< closed_pairs() of the accepted state

    /// Whether a point is closed, by pair, in the state that the points know.
    /// Collective.
    std::vector<bool>
    closed_pairs() const;
  };
} // namespace stickslip

#endif
