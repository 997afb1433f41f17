#include <stickslip/linear_solvers/automatic_solver.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    /// Unknowns up to which MUMPS is faster (measured, doc/theory.md): its
    /// factors are much smaller in the plane than in space.
    types::global_dof_index
    largest_direct_system(const std::string &text,
                          const unsigned int n_components)
    {
      if (text != "automatic")
        return Utilities::string_to_int(text);
      return n_components < 3 ? 150000 : 6000;
    }

    constexpr unsigned int            n_slow_solves       = 3; // in a row
    constexpr unsigned int            first_n_direct      = 10;
    constexpr unsigned int            largest_n_direct    = 20;
    constexpr types::global_dof_index largest_slow_system = 50000;

    /// Krylov iterations that cost more than MUMPS: an iteration is
    /// proportional to the size, a factorisation to its square. Measured: 36
    /// iterations with 25,000 unknowns, where 60 leave bulky bodies, whose
    /// factors are larger, to the iteration; and so do 60 in smaller systems.
    double
    worthwhile_iterations(const types::global_dof_index size)
    {
      return 60. * std::max(1., size / 25000.);
    }
  } // namespace



  SlowIteration::SlowIteration()
    : next_n_direct(first_n_direct)
  {}



  void
  SlowIteration::record(const unsigned int            iterations,
                        const types::global_dof_index size,
                        const bool                    has_converged)
  {
    if (has_converged && iterations <= worthwhile_iterations(size))
      {
        *this = SlowIteration();
        return;
      }
    if (++n_slow < n_slow_solves)
      return;
    n_slow        = n_slow_solves - 1; // one more is enough later
    n_direct      = next_n_direct;
    next_n_direct = std::min(2 * next_n_direct, largest_n_direct);
  }



  bool
  SlowIteration::prefers_direct(const types::global_dof_index size)
  {
    if (n_direct == 0 || size > largest_slow_system)
      return false;
    --n_direct;
    return true;
  }



  AutomaticSolver::AutomaticSolver(const LinearSolverParameters &parameters)
    : parameters(parameters)
    , iterative(parameters)
  {}



  void
  AutomaticSolver::setup(const LA::BlockSparseMatrix &system,
                         const SystemDescriber       &describer)
  {
    matrix    = &system;
    describe  = describer;
    failure   = "";
    is_direct = system.m() <=
                  largest_direct_system(parameters.largest_direct_system, 3) ||
                (parameters.largest_direct_system == "automatic" &&
                 slow_iteration.prefers_direct(system.m()));
    if (!is_direct &&
        system.m() <=
          largest_direct_system(parameters.largest_direct_system, 2))
      is_direct =
        system.m() <= largest_direct_system(parameters.largest_direct_system,
                                            describe().n_components);
    if (is_direct)
      {
        direct.setup(system, describe);
        return;
      }
    try
      {
        iterative.setup(system, describe);
      }
    catch (const NoConvergence &error)
      {
        failure = error.what();
      }
  }



  LinearSolve
  AutomaticSolver::solve(LA::BlockVector       &x,
                         const LA::BlockVector &b,
                         const double           sufficient)
  {
    if (is_direct)
      return direct.solve(x, b, sufficient);
    if (failure.empty())
      try
        {
          const LinearSolve result = iterative.solve(x, b, sufficient);
          slow_iteration.record(result.iterations, matrix->m());
          return result;
        }
      catch (const NoConvergence &error)
        {
          failure = error.what();
          slow_iteration.record(0, matrix->m(), false);
        }
    DirectSolver instead; // its memory is needed now and then only
    instead.setup(*matrix, describe);
    LinearSolve result      = instead.solve(x, b, sufficient);
    result.direct_fallbacks = 1;
    result.note             = failure + "; solved by MUMPS";
    return result;
  }
} // namespace stickslip
