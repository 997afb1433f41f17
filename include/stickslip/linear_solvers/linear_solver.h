#ifndef stickslip_linear_solvers_linear_solver_h
#define stickslip_linear_solvers_linear_solver_h

#include <stickslip/base/block_system.h>
#include <stickslip/base/solve_counts.h>
#include <stickslip/base/types.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  struct LinearSolverParameters
  {
    std::string  name                  = "automatic";
    double       relative_tolerance    = 1e-8;
    unsigned int max_iterations        = 200;
    double       augmentation          = 4.;
    double       rebuild_factor        = 1.5;
    unsigned int largest_zone          = 100000;
    std::string  largest_direct_system = "automatic";

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError.
    void
    check(const std::string &path) const;
  };



  /// What a linear solve took.
  struct LinearSolve
  {
    unsigned int iterations       = 0; ///< of a Krylov method; 1 if direct
    unsigned int multigrid_setups = 0;
    unsigned int direct_fallbacks = 0;
    std::string  note; ///< for the log: why it fell back
  };



  /**
   * Solves the block system [displacements, multipliers]. Knows nothing of
   * mechanics. All functions are collective and throw NoConvergence if the
   * matrix is singular or an iteration does not converge.
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Prepares for solves with @p matrix, which must stay as it is until the
    /// next call. @p describe is called only if the solver wants to know more.
    virtual void
    setup(const LA::BlockSparseMatrix &matrix,
          const SystemDescriber       &describe) = 0;

    /// Solves for @p x (its value does not matter). A residual of
    /// @p sufficient, beside that of b, will do; iterations stop at the larger
    /// one of this and their `Relative tolerance`.
    virtual LinearSolve
    solve(LA::BlockVector       &x,
          const LA::BlockVector &b,
          const double           sufficient) = 0;

    /// setup() and solve(), with times and counts added to @p counts. Returns
    /// what the log should say, mostly nothing.
    std::string
    solve_system(const LA::BlockSparseMatrix &matrix,
                 const SystemDescriber       &describe,
                 const LA::BlockVector       &b,
                 const double                 sufficient,
                 LA::BlockVector             &x,
                 SolveCounts                 &counts);
  };



  /// Makes the solver that the .prm names, which keeps a copy of the
  /// parameters. Throws UserError for unknown names.
  std::unique_ptr<LinearSolver>
  create_linear_solver(const LinearSolverParameters &parameters);

  std::vector<std::string>
  linear_solver_names();
} // namespace stickslip

#endif
