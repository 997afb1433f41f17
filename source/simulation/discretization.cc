#include <stickslip/simulation/discretization.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/rigid_body_check.h>

#include <stickslip/strategy/solution_strategy.h>

#include <string>
#include <vector>

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



    /// With an algorithm that solves with the stiffness of the bodies alone.
    void
    check_contact_need_not_hold(const Algorithm                algorithm,
                                const std::vector<FreeMotion> &motions)
    {
      if (motions.empty())
        return;
      std::string text = "'Algorithm/Name = " + name_of(algorithm) +
                         "' needs bodies that are held without contact, but "
                         "nothing else holds or drives these rigid body "
                         "motions:";
      for (const FreeMotion &motion : motions)
        text += "\n  " + motion.text();
      throw UserError(text +
                      "\nTake another algorithm, such as automatic, or "
                      "add a condition in section 'Boundary "
                      "conditions'.");
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
    if (needs_held_bodies(parameters.algorithm.name))
      check_contact_need_not_hold(parameters.algorithm.name,
                                  problem.free_motions());
    if (parameters.adaptation.is_active())
      check_pairs_can_be_transferred(problem.contact());
  }

  template struct Discretization<2>;
  template struct Discretization<3>;
} // namespace stickslip
