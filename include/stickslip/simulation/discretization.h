#ifndef stickslip_simulation_discretization_h
#define stickslip_simulation_discretization_h

#include <stickslip/base/amplitude.h>
#include <stickslip/base/stop_requests.h>

#include <stickslip/linear_solvers/linear_solver.h>

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/case_parameters.h>
#include <stickslip/simulation/convergence_log.h>
#include <stickslip/simulation/step_solver.h>

#include <memory>

namespace stickslip
{
  /// What belongs to one mesh: when that changes, it is made anew.
  template <int dim>
  struct Discretization
  {
    /// The arguments must outlive this object. Throws UserError. Collective.
    Discretization(const CaseParameters &parameters,
                   const Amplitudes     &amplitudes,
                   Mesh<dim>            &mesh,
                   ConvergenceLog       &log,
                   const StopRequests   &stop_requests);

    ContactProblem<dim>                 problem;
    const std::unique_ptr<LinearSolver> linear_solver;
    StepSolver<dim>                     step_solver;
  };
} // namespace stickslip

#endif
