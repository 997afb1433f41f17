#ifndef stickslip_linear_solvers_projected_conjugate_gradient_h
#define stickslip_linear_solvers_projected_conjugate_gradient_h

#include <stickslip/base/types.h>

#include <functional>
#include <vector>

namespace stickslip
{
  /**
   * The multipliers that a contact problem admits: lambda_n <= 0 and
   * |Lambda| <= 1 at every multiplier node, nothing at nodes without contact.
   */
  struct AdmissibleMultipliers
  {
    /// A multiplier node of this rank: consecutive dofs lambda_n, Lambda.
    struct Node
    {
      types::global_dof_index first_dof;
      unsigned int            n_components; ///< 1 or dim
      bool has_contact  = true;             ///< else all components are zero
      bool has_friction = true;             ///< else Lambda is zero
    };

    std::vector<Node> nodes;

    /// Moves @p y to the nearest admissible multipliers.
    void
    project(LA::Vector &y) const;

    /// The largest @p change of lambda_n over the largest |lambda_n| of @p y,
    /// or of Lambda. Collective.
    double
    largest_change(const LA::Vector &y, const LA::Vector &change) const;

    /// Takes out of @p direction what leads out of the admissible set at the
    /// admissible @p y at once.
    void
    project_direction(const LA::Vector &y, LA::Vector &direction) const;
  };



  /// What a solve took.
  struct ProjectedSolve
  {
    unsigned int iterations = 0;
    unsigned int solves     = 0; ///< with the displacement block
  };

  /**
   * Projected conjugate gradient (Renouf and Alart 2005, "Conjugate gradient
   * type algorithms for frictional multi-contact problems", algorithm GPCP) for
   * the multipliers y of
   *
   *   K du + B^T (y - y0) = r_u,   (B du - r_y) . (z - y) <= 0 for admissible z
   *
   * with a symmetric positive definite K, which is factorised: bodies have to
   * be held without contact. It maximises the dual energy; the Schur complement
   * is scaled by an estimate of its diagonal.
   */
  class ProjectedConjugateGradient
  {
  public:
    ProjectedConjugateGradient(const double       tolerance,
                               const unsigned int max_iterations);

    /**
     * Solves for @p increment = [du, y - y0]. @p diagonal estimates the
     * diagonal of B K^-1 B^T (0: no contact). Throws NoConvergence if K is
     * singular or the iteration limit is reached. Collective.
     */
    ProjectedSolve
    solve(const LA::BlockSparseMatrix &matrix,
          const LA::BlockVector       &rhs,
          const LA::Vector            &diagonal,
          const AdmissibleMultipliers &admissible,
          const LA::Vector            &y0,
          LA::BlockVector             &increment) const;

  private:
    const double       tolerance;
    const unsigned int max_iterations;
  };
} // namespace stickslip

#endif
