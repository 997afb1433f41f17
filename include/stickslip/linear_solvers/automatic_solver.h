#ifndef stickslip_linear_solvers_automatic_solver_h
#define stickslip_linear_solvers_automatic_solver_h

#include <stickslip/linear_solvers/block_amg_solver.h>
#include <stickslip/linear_solvers/direct_solver.h>

#include <string>

namespace stickslip
{
  /**
   * MUMPS for systems that it solves faster, block AMG for larger ones; and
   * MUMPS again where the iteration fails, so that a step is not given up for
   * the solver's sake.
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
  };
} // namespace stickslip

#endif
