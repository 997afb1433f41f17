#ifndef stickslip_linear_solvers_displacement_multigrid_h
#define stickslip_linear_solvers_displacement_multigrid_h

#include <stickslip/base/block_system.h>

namespace stickslip
{
  /**
   * One multigrid cycle for a matrix of displacements: algebraic multigrid by
   * smoothed aggregation with the near null space of the description. For
   * elements of a higher degree it works on the linear ones (Galerkin), with a
   * symmetric Gauss-Seidel sweep on the fine matrix before and after.
   */
  class DisplacementMultigrid
  {
  public:
    /// Keeps a reference to @p matrix. Throws NoConvergence. Collective.
    void
    reinit(const LA::SparseMatrix       &matrix,
           const BlockSystemDescription &description);

    /// Forgets the matrix; must be called before it is changed.
    void
    clear();

    /// One cycle with a zero initial guess. Collective.
    void
    vmult(LA::Vector &x, const LA::Vector &b) const;

  private:
    const LA::SparseMatrix                 *fine_matrix = nullptr;
    std::shared_ptr<const LA::SparseMatrix> prolongation;
    std::shared_ptr<const NearNullSpace>    near_null_space;
    LA::SymmetricGaussSeidel                fine_smoother;
    LA::SparseMatrix                        coarse_matrix;
    LA::AlgebraicMultigrid                  hierarchy;
    mutable LA::Vector residual, correction, coarse_residual, coarse_correction;
  };
} // namespace stickslip

#endif
