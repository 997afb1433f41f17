#include <stickslip/base/registry.h>

#include <stickslip/linear_solvers/direct_solver.h>
#include <stickslip/linear_solvers/linear_solver.h>

namespace stickslip
{
  namespace
  {
    const Registry<LinearSolver> &
    linear_solver_registry()
    {
      static const Registry<LinearSolver> registry(
        "linear solver", {{"MUMPS", "parallel sparse direct solver", [] {
                             return std::make_unique<DirectSolver>();
                           }}});
      return registry;
    }
  } // namespace



  void
  LinearSolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Name",
                      name,
                      linear_solver_registry().descriptions(),
                      Patterns::Selection(
                        linear_solver_registry().selection()));
  }



  std::unique_ptr<LinearSolver>
  create_linear_solver(const LinearSolverParameters &parameters)
  {
    return linear_solver_registry().create(parameters.name,
                                           "Linear solver/Name");
  }



  std::vector<std::string>
  linear_solver_names()
  {
    return linear_solver_registry().names();
  }
} // namespace stickslip
