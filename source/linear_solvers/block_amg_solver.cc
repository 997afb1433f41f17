#include <stickslip/linear_solvers/block_amg_solver.h>

#include <stickslip/base/no_convergence.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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



    /// What a new hierarchy costs, in iterations. A hierarchy is given up after
    /// that many more than its best solve would have taken.
    constexpr double renewal_cost = 8.;



    /// Share of the augmentation that may change before the hierarchy has to.
    /// (0.05 and 0.15 took 3 hierarchies and 39 iterations for P1 size L where
    /// this takes 2 and 41; with 0.3 iterations of partly open cubes grew with
    /// the mesh.)
    constexpr double outdated_share = 0.2;



    /// Solves to less than this reduction of the residual are short: an
    /// outdated hierarchy costs them less than its renewal would (about eight
    /// iterations).
    constexpr double loose_reduction = 1e-4;
  } // namespace



  BlockAmgSolver::BlockAmgSolver(const LinearSolverParameters &parameters)
    : parameters(parameters)
    , interface(parameters.largest_zone)
  {}



  void
  BlockAmgSolver::build_hierarchy()
  {
    multigrid.clear();
    BlockRows<double> added;
    if (has_multipliers)
      added = augmentation.added_blocks(description->n_components);
    built_stiffness = augmentation.added_stiffness();
    multigrid.reinit(matrix->block(0, 0), added, *description);
    near_null_space = description->near_null_space;
    is_fresh        = true;
    rebuild         = false;
    best            = 0.;
    excess          = 0.;
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
    const LA::Vector &inverse_diagonal = augmentation.inverse_diagonal();
    row_scale.clear();
    for (const auto i : inverse_diagonal.locally_owned_elements())
      {
        const double square = inverse_diagonal(i) * description->stiffness(i);
        row_scale.push_back(square > 0. ? std::sqrt(square) : 1.);
      }
  }



  void
  BlockAmgSolver::apply_row_scale(OwnedEntries &entries) const
  {
    double *const multipliers = entries.data() + product.n_displacements();
    for (unsigned int i = 0; i < row_scale.size(); ++i)
      multipliers[i] *= row_scale[i];
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
    product.reinit(system);
    augmentation.reinit(system, *description, parameters.augmentation);
    scale_rows();
    const bool needs_hierarchy =
      description->near_null_space != near_null_space || rebuild;
    if (has_multipliers)
      {
        // The interface makes up for springs that the hierarchy has of contacts
        // that have opened since.
        if (interface.determine_unknowns(
              system, new_layout, needs_hierarchy ? nullptr : &built_stiffness))
          {
            const unsigned int n =
              product.n_displacements() + product.n_multipliers();
            correction.assign(n, 0.); // outside of the interface it stays so
            product.set_part(interface.marks(n));
          }
        interface.factorise(system);
      }
    if (needs_hierarchy)
      build_hierarchy();
    else
      is_outdated = hierarchy_is_outdated();
  }



  void
  BlockAmgSolver::precondition(OwnedEntries       &x,
                               OwnedEntries       &matrix_times_x,
                               const OwnedEntries &b) const
  {
    x.assign(b.size(), 0.);
    if (!has_multipliers)
      {
        multigrid.vmult(x.data(), b.data());
        product.vmult(matrix_times_x, x);
        return;
      }
    unscaled                  = b;
    double *const multipliers = unscaled.data() + product.n_displacements();
    for (unsigned int i = 0; i < row_scale.size(); ++i)
      multipliers[i] /= row_scale[i];
    residual = unscaled;
    augmentation.add_to(residual);
    multigrid.vmult(x.data(), residual.data());
    product.vmult_displacements(matrix_times_x, x);
    for (std::size_t i = 0; i < residual.size(); ++i)
      residual[i] = unscaled[i] - matrix_times_x[i];
    interface.solve(correction, residual);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += correction[i];
    product.add_part(matrix_times_x, correction);
    apply_row_scale(matrix_times_x);
  }



  FlexibleGmres::Result
  BlockAmgSolver::iterate(OwnedEntries       &x,
                          const OwnedEntries &b,
                          const double        tolerance,
                          const unsigned int  max_iterations) const
  {
    const FlexibleGmres solver(matrix->block(0, 0).get_mpi_communicator(),
                               krylov_vectors);
    return solver.solve(
      [&](OwnedEntries &y, const OwnedEntries &z) {
        product.vmult(y, z);
        apply_row_scale(y);
      },
      [&](OwnedEntries &y, OwnedEntries &y_product, const OwnedEntries &z) {
        precondition(y, y_product, z);
      },
      x,
      b,
      tolerance,
      max_iterations);
  }



  LinearSolve
  BlockAmgSolver::solve(LA::BlockVector       &x,
                        const LA::BlockVector &b,
                        const double           sufficient)
  {
    OwnedEntries rhs = owned_entries(b);
    apply_row_scale(rhs);
    const double reduction =
      std::max(parameters.relative_tolerance, std::min(sufficient, 0.1));
    const double digits = -std::log10(reduction);
    const double tolerance =
      reduction *
      FlexibleGmres::norm(rhs, matrix->block(0, 0).get_mpi_communicator());
    OwnedEntries solution(rhs.size(), 0.);
    if (is_outdated && !is_fresh && reduction < loose_reduction)
      build_hierarchy();
    LinearSolve           result;
    FlexibleGmres::Result last;
    last.converged     = tolerance == 0.;
    const auto attempt = [&](const unsigned int limit) {
      last = iterate(solution, rhs, tolerance, limit);
      result.iterations += last.iterations;
    };
    if (!last.converged && !is_fresh)
      {
        // give an old hierarchy up early
        attempt(std::min<double>(parameters.max_iterations,
                                 2. * best * digits + patience_with_old));
        if (!last.converged)
          build_hierarchy();
      }
    if (!last.converged)
      attempt(parameters.max_iterations);
    set_owned_entries(x, solution);
    result.multigrid_setups = n_new;
    n_new                   = 0;
    if (!last.converged)
      {
        rebuild = true;
        std::ostringstream text;
        text << "no convergence to " << reduction << " in " << last.iterations
             << " iterations";
        throw NoConvergence("Linear solver (block AMG)",
                            text.str(),
                            FailureCause::linear_solver);
      }
    const double per_digit = last.iterations / digits;
    if (is_fresh)
      best = per_digit;
    best                  = std::min(best, per_digit);
    const double expected = best * digits;
    excess += last.iterations - expected;
    rebuild = parameters.rebuild_factor == 0. || excess > renewal_cost ||
              last.iterations > std::max(parameters.rebuild_factor * expected,
                                         expected + usual_variation);
    return result;
  }
} // namespace stickslip
