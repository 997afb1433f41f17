#include <stickslip/linear_solvers/linear_solver.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/registry.h>
#include <stickslip/base/user_error.h>

#include <stickslip/linear_solvers/automatic_solver.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/timer.h>

namespace stickslip
{
  namespace
  {
    using LinearSolverRegistry =
      Registry<LinearSolver, const LinearSolverParameters &>;



    const LinearSolverRegistry &
    linear_solver_registry()
    {
      static const LinearSolverRegistry registry(
        "linear solver",
        {{"automatic",
          "MUMPS for small systems, block AMG for large ones, and MUMPS again "
          "if its iteration fails",
          [](const LinearSolverParameters &parameters) {
            return std::make_unique<AutomaticSolver>(parameters);
          }},
         {"MUMPS",
          "parallel sparse direct solver",
          [](const LinearSolverParameters &) {
            return std::make_unique<DirectSolver>();
          }},
         {"block AMG",
          "flexible GMRES, preconditioned by algebraic multigrid for the "
          "displacements and a direct solve in the contact zone",
          [](const LinearSolverParameters &parameters) {
            return std::make_unique<BlockAmgSolver>(parameters);
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
    prm.add_parameter("Largest direct system",
                      largest_direct_system,
                      expert(
                        "automatic: unknowns up to which MUMPS is used; "
                        "'automatic' takes what was measured to be faster."));
    prm.add_parameter(
      "Relative tolerance",
      relative_tolerance,
      expert(
        "block AMG: of the residual, relative to the right-hand side. Early "
        "Newton iterations may need less ('Forcing')."),
      Patterns::Double(1e-14, 0.1));
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      expert("block AMG: after these the solve has failed."),
                      Patterns::Integer(1));
    prm.add_parameter("Augmentation",
                      augmentation,
                      expert(
                        "block AMG: stiffness that multigrid sees in closed "
                        "contact, relative to that of the adjacent cells. It "
                        "changes iteration counts, not results."),
                      Patterns::Double(1e-6, 1e6));
    prm.add_parameter(
      "Largest zone",
      largest_zone,
      expert("block AMG: unknowns of the contact zone (multipliers, and "
             "displacements where they act) up to which it is factorised as a "
             "whole. A larger one is solved in overlapping parts of about this "
             "size, which may take more iterations."),
      Patterns::Integer(100));
    prm.add_parameter(
      "Rebuild factor",
      rebuild_factor,
      expert("block AMG: the multigrid hierarchy is kept for the next matrices "
             "until the contact state changes or a solve takes more iterations "
             "than the best one by this factor. 0: rebuilt for each matrix."),
      Patterns::Double(0.));
  }



  void
  LinearSolverParameters::check(const std::string &path) const
  {
    const bool is_number =
      !largest_direct_system.empty() && largest_direct_system.find_first_not_of(
                                          "0123456789") == std::string::npos;
    if (largest_direct_system != "automatic" && !is_number)
      throw UserError("'" + path + "/Largest direct system' = '" +
                      largest_direct_system +
                      "': it must be a number of unknowns (0, 1, 2, ...) or "
                      "automatic.");
  }



  std::string
  LinearSolver::solve_system(const LA::BlockSparseMatrix &matrix,
                             const SystemDescriber       &describe,
                             const LA::BlockVector       &b,
                             const double                 sufficient,
                             LA::BlockVector             &x,
                             SolveCounts                 &counts)
  {
    Timer timer;
    setup(matrix, describe);
    counts.setup_seconds += timer.wall_time();
    timer.restart();
    const LinearSolve result = solve(x, b, sufficient);
    counts.solve_seconds += timer.wall_time();
    counts.linear_iterations += result.iterations;
    counts.multigrid_setups += result.multigrid_setups;
    counts.direct_fallbacks += result.direct_fallbacks;
    return result.note;
  }



  std::unique_ptr<LinearSolver>
  create_linear_solver(const LinearSolverParameters &parameters)
  {
    return linear_solver_registry().create(parameters.name,
                                           "Linear solver/Name",
                                           parameters);
  }



  std::vector<std::string>
  linear_solver_names()
  {
    return linear_solver_registry().names();
  }
} // namespace stickslip
