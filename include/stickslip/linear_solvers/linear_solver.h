#ifndef stickslip_linear_solvers_linear_solver_h
#define stickslip_linear_solvers_linear_solver_h

#include <stickslip/base/types.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  struct LinearSolverParameters
  {
    std::string name = "MUMPS";

    void
    add_parameters(ParameterHandler &prm);
  };



  /**
   * Solves the block system [displacements, multipliers]. Knows nothing of
   * mechanics. Both functions are collective and throw NoConvergence if the
   * matrix is singular.
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Prepares for solves with @p matrix, which must stay as it is.
    virtual void
    setup(const LA::BlockSparseMatrix &matrix) = 0;

    /// Solves for @p x; returns the Krylov iterations (1 for a direct solver).
    virtual unsigned int
    solve(LA::BlockVector &x, const LA::BlockVector &b) = 0;
  };



  /// Makes the solver that the .prm names. Throws UserError for unknown names.
  std::unique_ptr<LinearSolver>
  create_linear_solver(const LinearSolverParameters &parameters);

  std::vector<std::string>
  linear_solver_names();
} // namespace stickslip

#endif
