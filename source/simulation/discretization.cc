#include <stickslip/simulation/discretization.h>

#include <stickslip/base/user_error.h>

namespace stickslip
{
  namespace
  {
    /// Who is slave of a surface that meets itself is not carried to another
    /// mesh.
    template <int dim>
    void
    check_pairs_can_be_transferred(const ContactAssembler<dim> &contact)
    {
      for (const auto &pair : contact.contact_pairs())
        if (pair->meets_itself())
          throw UserError(
            "'Adaptation/Estimator' is given, but the slave and the master "
            "set of 'Contact/" +
            pair->name +
            "' share a boundary: the mesh of a surface that meets itself "
            "cannot be adapted. Take section 'Refinement'.");
    }
  } // namespace



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
    if (parameters.adaptation.is_active())
      check_pairs_can_be_transferred(problem.contact());
  }

  template struct Discretization<2>;
  template struct Discretization<3>;
} // namespace stickslip
