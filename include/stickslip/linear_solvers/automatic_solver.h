#ifndef stickslip_linear_solvers_automatic_solver_h
#define stickslip_linear_solvers_automatic_solver_h

#include <stickslip/linear_solvers/block_amg_solver.h>
#include <stickslip/linear_solvers/direct_solver.h>

#include <string>

namespace stickslip
{
  /**
   * Whether MUMPS is faster for systems in space that are small enough to be
   * factorised: after three solves in a row that took more Krylov iterations
   * than a factorisation is worth (thin walls of long cells). It solves the
   * next ten systems then, and twenty whenever the iteration is still slow
   * after these: slow solves may be those of a few bad states, and one in
   * twenty costs little where they are not. Counts decide, not times, so that a
   * run can be repeated.
   */
  class SlowIteration
  {
  public:
    SlowIteration();

    /// A solve by the iteration; without convergence a slow one.
    void
    record(const unsigned int            iterations,
           const types::global_dof_index size,
           const bool                    has_converged = true);

    /// Whether the next system is for MUMPS. To be asked once for each.
    bool
    prefers_direct(const types::global_dof_index size);

  private:
    unsigned int n_slow   = 0; ///< in a row
    unsigned int n_direct = 0; ///< systems that are still for MUMPS
    unsigned int next_n_direct;
  };



  /**
   * MUMPS for systems that it solves faster, block AMG for larger ones; and
   * MUMPS again where the iteration is slow (SlowIteration) or fails, so that a
   * step is not given up for the solver's sake.
   */
  class AutomaticSolver : public LinearSolver
  {
  public:
    explicit AutomaticSolver(const LinearSolverParameters &parameters);

    void
    setup(const LA::BlockSparseMatrix &matrix,
          const SystemDescriber       &describe) override;

    LinearSolve
    solve(LA::BlockVector       &x,
          const LA::BlockVector &b,
          const double           sufficient) override;

  private:
    const LinearSolverParameters parameters;
    DirectSolver                 direct;
    BlockAmgSolver               iterative;
    const LA::BlockSparseMatrix *matrix = nullptr;
    SystemDescriber              describe;
    bool                         is_direct = true;
    std::string                  failure; ///< of the iterative set-up
    SlowIteration                slow_iteration;
  };
} // namespace stickslip

#endif
