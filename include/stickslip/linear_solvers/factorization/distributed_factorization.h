#ifndef stickslip_linear_solvers_factorization_distributed_factorization_h
#define stickslip_linear_solvers_factorization_distributed_factorization_h

#include <stickslip/base/types.h>

#include <stickslip/linear_solvers/factorization/factorization_error.h>

#include <memory>

namespace stickslip
{
  /**
   * LU factors of a distributed matrix by MUMPS, through Amesos. Unlike
   * deal.II's SolverDirect it says what went wrong, and it repeats a
   * factorisation for which the workspace was too small.
   *
   * MUMPS allocates its workspace before it pivots, and estimates it without
   * looking at the values. With pivots off the diagonal, as in a saddle point
   * matrix, or on many ranks the estimate may fall short. Each time it does,
   * the supplement (ICNTL(14), per cent of the estimate) is doubled; it stays
   * so for the matrices that follow.
   */
  class DistributedFactorization
  {
  public:
    /// Supplement to the workspace that MUMPS estimates, in per cent.
    static constexpr int usual_supplement = 20;

    /// How MUMPS numbers the unknowns (ICNTL(7)) to keep the factors sparse.
    enum class Ordering
    {
      automatic,   ///< what MUMPS takes for best: a bisection, if it has one
      minimum_fill ///< approximate minimum fill
    };

    /// @p supplement: the first one tried [per cent].
    explicit DistributedFactorization(const int supplement = usual_supplement);

    ~DistributedFactorization();

    /// Factorises @p matrix, which must outlive the factors. Returns the same on
    /// all ranks. Collective.
    [[nodiscard]] FactorizationError
    factorise(const LA::SparseMatrix &matrix,
              const Ordering          ordering = Ordering::automatic);

    /// Factorises the matrix of the last factorise() with the values that it
    /// has now, in the order found then. What fails here may succeed in an
    /// order of its own. Returns the same on all ranks, an error if there are
    /// no factors. Collective.
    [[nodiscard]] FactorizationError
    refactorise();

    /// Solves for @p x, whose layout is that of @p b and of the rows. Returns
    /// the same on all ranks. Collective.
    [[nodiscard]] FactorizationError
    solve(LA::Vector &x, const LA::Vector &b) const;

    /// Frees the factors. Collective.
    void
    clear();

    /// The supplement to the workspace that was enough so far, in per cent.
    int
    workspace_supplement() const
    {
      return supplement;
    }

  private:
    struct Factors;

    int                      supplement;
    std::unique_ptr<Factors> factors;
  };
} // namespace stickslip

#endif
