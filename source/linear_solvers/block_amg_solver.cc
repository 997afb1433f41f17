#include <stickslip/linear_solvers/block_amg_solver.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector_memory.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Directions that GMRES keeps before it restarts; each takes the memory of
    /// two solutions.
    constexpr unsigned int krylov_vectors = 60;



    /// Iterations more than the best ones that never count as slow.
    constexpr unsigned int usual_variation = 3;



    /// An old hierarchy is given up after twice the best iterations and this
    /// many.
    constexpr unsigned int patience_with_old = 12;



    /// Share of the augmentation that may change before the hierarchy has to.
    constexpr double outdated_share = 0.1;



    /// Solves to less than this reduction of the residual are short: an
    /// outdated hierarchy costs them less than its renewal would (about ten
    /// iterations).
    constexpr double loose_reduction = 1e-4;



    /// y = A x without the empty blocks of a problem without contact.
    void
    apply(const LA::BlockSparseMatrix &matrix,
          LA::BlockVector             &y,
          const LA::BlockVector       &x)
    {
      if (x.block(1).size() > 0)
        matrix.vmult(y, x);
      else
        matrix.block(0, 0).vmult(y.block(0), x.block(0));
    }



    /// The matrix of the iteration: rows of multipliers scaled.
    class ScaledMatrix
    {
    public:
      ScaledMatrix(const LA::BlockSparseMatrix &matrix,
                   const LA::Vector            &row_scale)
        : matrix(matrix)
        , row_scale(row_scale)
      {}

      void
      vmult(LA::BlockVector &y, const LA::BlockVector &x) const
      {
        apply(matrix, y, x);
        y.block(1).scale(row_scale);
      }

    private:
      const LA::BlockSparseMatrix &matrix;
      const LA::Vector            &row_scale;
    };
  } // namespace



  BlockAmgSolver::BlockAmgSolver(const LinearSolverParameters &parameters)
    : parameters(parameters)
    , interface(parameters.largest_zone)
  {}



  void
  BlockAmgSolver::build_hierarchy()
  {
    multigrid.clear();
    LA::SparseMatrix added;
    if (has_multipliers)
      augmentation.build_matrix(added);
    built_stiffness = augmentation.added_stiffness();
    multigrid.reinit(matrix->block(0, 0), added, *description);
    near_null_space = description->near_null_space;
    is_fresh        = true;
    rebuild         = false;
    best            = 0.;
    is_outdated     = false;
    ++n_new;
  }



  bool
  BlockAmgSolver::hierarchy_is_outdated() const
  {
    LA::Vector change = augmentation.added_stiffness();
    change -= built_stiffness;
    return change.l1_norm() > outdated_share * built_stiffness.l1_norm();
  }



  void
  BlockAmgSolver::scale_rows()
  {
    row_scale         = augmentation.inverse_diagonal();
    inverse_row_scale = row_scale;
    for (const auto i : row_scale.locally_owned_elements())
      {
        const double square  = row_scale(i) * description->stiffness(i);
        const double factor  = square > 0. ? std::sqrt(square) : 1.;
        row_scale(i)         = factor;
        inverse_row_scale(i) = 1. / factor;
      }
    row_scale.compress(VectorOperation::insert);
    inverse_row_scale.compress(VectorOperation::insert);
  }



  void
  BlockAmgSolver::setup(const LA::BlockSparseMatrix &system,
                        const SystemDescriber       &describe)
  {
    matrix                = &system;
    description           = &describe();
    has_multipliers       = system.block(1, 1).m() > 0;
    const bool new_layout = description->layout != layout;
    layout                = description->layout;
    n_new                 = 0;
    is_fresh              = false;
    augmentation.reinit(system, *description, parameters.augmentation);
    scale_rows();
    unscaled.reinit({system.block(0, 0).locally_owned_range_indices(),
                     system.block(1, 1).locally_owned_range_indices()},
                    system.block(0, 0).get_mpi_communicator());
    residual.reinit(unscaled);
    if (has_multipliers)
      interface.factorise(system, new_layout);
    if (description->near_null_space != near_null_space || rebuild)
      build_hierarchy();
    else
      is_outdated = hierarchy_is_outdated();
  }



  void
  BlockAmgSolver::vmult(LA::BlockVector &x, const LA::BlockVector &b) const
  {
    if (!has_multipliers)
      {
        multigrid.vmult(x.block(0), b.block(0));
        return;
      }
    unscaled = b;
    unscaled.block(1).scale(inverse_row_scale);
    residual = unscaled;
    augmentation.add_to(unscaled.block(1), residual.block(0));
    multigrid.vmult(x.block(0), residual.block(0));
    x.block(1) = 0.;
    apply(*matrix, residual, x);
    residual.sadd(-1., 1., unscaled);
    interface.add_correction(residual, x);
  }



  unsigned int
  BlockAmgSolver::iterate(LA::BlockVector       &x,
                          const LA::BlockVector &b,
                          const double           tolerance,
                          const unsigned int     max_iterations,
                          bool                  &converged) const
  {
    SolverControl control(max_iterations, tolerance, false, false);
    SolverFGMRES<LA::BlockVector> solver(
      control, SolverFGMRES<LA::BlockVector>::AdditionalData(krylov_vectors));
    converged = true;
    try
      {
        solver.solve(ScaledMatrix(*matrix, row_scale), x, b, *this);
      }
    catch (const SolverControl::NoConvergence &)
      {
        converged = false;
      }
    return control.last_step();
  }



  LinearSolve
  BlockAmgSolver::solve(LA::BlockVector       &x,
                        const LA::BlockVector &b,
                        const double           sufficient)
  {
    LA::BlockVector rhs(b);
    rhs.block(1).scale(row_scale);
    const double reduction =
      std::max(parameters.relative_tolerance, std::min(sufficient, 0.1));
    const double digits    = -std::log10(reduction);
    const double tolerance = reduction * rhs.l2_norm();
    x                      = 0.;
    if (is_outdated && !is_fresh && reduction < loose_reduction)
      build_hierarchy();
    LinearSolve result;
    bool        converged = tolerance == 0.;
    if (!converged && !is_fresh)
      {
        // give an old hierarchy up early
        const unsigned int patience =
          std::min<double>(parameters.max_iterations,
                           2. * best * digits + patience_with_old);
        result.iterations = iterate(x, rhs, tolerance, patience, converged);
        if (!converged)
          build_hierarchy();
      }
    unsigned int iterations = result.iterations;
    if (!converged)
      {
        iterations =
          iterate(x, rhs, tolerance, parameters.max_iterations, converged);
        result.iterations += iterations;
      }
    // its pool would keep them
    GrowingVectorMemory<LA::BlockVector>::release_unused_memory();
    result.multigrid_setups = n_new;
    n_new                   = 0;
    if (!converged)
      {
        rebuild = true;
        std::ostringstream text;
        text << "no convergence to " << reduction << " in " << iterations
             << " iterations";
        throw NoConvergence("Linear solver (block AMG)",
                            text.str(),
                            FailureCause::linear_solver);
      }
    const double per_digit = iterations / digits;
    if (is_fresh)
      best = per_digit;
    best                  = std::min(best, per_digit);
    const double expected = best * digits;
    rebuild               = parameters.rebuild_factor == 0. ||
              iterations > std::max(parameters.rebuild_factor * expected,
                                    expected + usual_variation);
    return result;
  }
} // namespace stickslip
