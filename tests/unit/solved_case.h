// Shared by tests: a case and its solution.

#ifndef stickslip_tests_solved_case_h
#define stickslip_tests_solved_case_h

#include "case_problem.h"

#include <stickslip/adaptivity/error_estimate.h>

#include <stickslip/linear_solvers/linear_solver.h>

#include <string>

namespace
{
  /// A case with its solution at time 1, accepted after a few Newton
  /// iterations.
  template <int dim>
  class SolvedCase : public CaseProblem<dim>
  {
  public:
    using CaseProblem<dim>::problem;

    explicit SolvedCase(const std::string &prm_text,
                        const unsigned int n_iterations = 6)
      : CaseProblem<dim>(prm_text)
      , x(problem.zero_state())
    {
      LinearSolverParameters linear_solver;
      linear_solver.name = "MUMPS";
      const auto  solver = create_linear_solver(linear_solver);
      SolveCounts counts;
      problem.begin_step(1., x);
      problem.configure(x, true);
      for (unsigned int i = 0; i < n_iterations; ++i)
        {
          problem.begin_iteration(x);
          problem.residual(x);
          problem.assemble(x);
          LA::BlockVector increment = problem.zero_state();
          solver->solve_system(
            problem.matrix(),
            [this]() -> const BlockSystemDescription & {
              return problem.describe_system();
            },
            problem.right_hand_side(),
            0.,
            increment,
            counts);
          problem.distribute(increment);
          x += increment;
        }
      problem.begin_iteration(x);
      problem.accept_step(x);
    }

    ErrorEstimate
    estimate(const std::string &name, const double distance = 0.)
    {
      AdaptationParameters parameters;
      parameters.estimator = name;
      parameters.distance  = distance;
      return estimate_error(*create_error_estimator<dim>(parameters),
                            problem,
                            x);
    }

    LA::BlockVector x;
  };
} // namespace

#endif
