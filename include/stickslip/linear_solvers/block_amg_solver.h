#ifndef stickslip_linear_solvers_block_amg_solver_h
#define stickslip_linear_solvers_block_amg_solver_h

#include <stickslip/linear_solvers/block_product.h>
#include <stickslip/linear_solvers/flexible_gmres.h>
#include <stickslip/linear_solvers/interface_augmentation.h>
#include <stickslip/linear_solvers/interface_solver.h>
#include <stickslip/linear_solvers/linear_solver.h>
#include <stickslip/linear_solvers/multigrid/displacement_multigrid.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Flexible GMRES on [A C; B -E], preconditioned by a multigrid cycle on the
   * augmented displacement block A + B^T D^-1 B followed by a solve of
   * the residual that is left on the contact interface. No Schur complement is
   * approximated.
   *
   * The multigrid hierarchy is kept while constraints and most of the
   * augmentation stay (loose solves also do with less), until a solve takes
   * `Rebuild factor` times as many iterations by digit as the best one with it,
   * or all together as many more as a new one would cost; the interface is
   * factorised for every matrix.
   */
  class BlockAmgSolver : public LinearSolver
  {
  public:
    explicit BlockAmgSolver(const LinearSolverParameters &parameters);

    void
    setup(const LA::BlockSparseMatrix &matrix,
          const SystemDescriber       &describe) override;

    LinearSolve
    solve(LA::BlockVector       &x,
          const LA::BlockVector &b,
          const double           sufficient) override;

  private:
    const LinearSolverParameters  parameters;
    const LA::BlockSparseMatrix  *matrix          = nullptr;
    const BlockSystemDescription *description     = nullptr;
    bool                          has_multipliers = false;
    unsigned int                  layout          = 0;

    InterfaceAugmentation augmentation;
    LA::Vector            built_stiffness; ///< added in the hierarchy
    DisplacementMultigrid multigrid;
    /// of the hierarchy
    std::shared_ptr<const NearNullSpace> near_null_space;
    mutable InterfaceSolver              interface;

    /// Makes rows of multipliers as large as those of displacements: B row in
    /// units of a gap, times a stiffness.
    std::vector<double>  row_scale; ///< by owned multiplier
    BlockProduct         product;
    mutable OwnedEntries unscaled, residual, correction;

    bool         is_fresh    = false; ///< the hierarchy is of this matrix
    bool         rebuild     = true;
    bool         is_outdated = false; ///< see hierarchy_is_outdated()
    double       best        = 0.; ///< iterations by digit with this hierarchy
    double       excess      = 0.; ///< iterations more than with the best
    unsigned int n_new       = 0;  ///< hierarchies since the last solve

    void
    build_hierarchy();

    /// The contact state has changed much since the hierarchy was made.
    /// Collective.
    bool
    hierarchy_is_outdated() const;

    void
    scale_rows();

    /// The preconditioner, for rows scaled as in the iteration, and the matrix
    /// times @p x. Collective.
    void
    precondition(OwnedEntries       &x,
                 OwnedEntries       &matrix_times_x,
                 const OwnedEntries &b) const;

    FlexibleGmres::Result
    iterate(OwnedEntries       &x,
            const OwnedEntries &b,
            const double        tolerance,
            const unsigned int  max_iterations) const;

    /// Multiplies the multipliers of @p entries with the scales of their rows.
    void
    apply_row_scale(OwnedEntries &entries) const;
  };
} // namespace stickslip

#endif
