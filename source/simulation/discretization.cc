#include <stickslip/simulation/discretization.h>

namespace stickslip
{
  template <int dim>
  Discretization<dim>::Discretization(const CaseParameters &parameters,
                                      const Amplitudes     &amplitudes,
                                      Mesh<dim>            &mesh,
                                      ConvergenceLog       &log,
                                      const StopRequests   &stop_requests)
    : problem(mesh,
              parameters.degree,
              parameters.materials,
              parameters.boundary_conditions,
              parameters.contact_pairs,
              parameters.algorithm.tangent == Tangent::quasi,
              amplitudes)
    , linear_solver(create_linear_solver(parameters.linear_solver))
    , step_solver(parameters, problem, *linear_solver, log, stop_requests)
  {
    problem.solid().stabilization().activate(
      parameters.load_stepping.stabilization_factor,
      parameters.load_stepping.end_time);
    problem.check_bodies_are_held();
  }

  template struct Discretization<2>;
  template struct Discretization<3>;
} // namespace stickslip
