#ifndef stickslip_linear_solvers_flexible_gmres_h
#define stickslip_linear_solvers_flexible_gmres_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * Flexible GMRES (Saad, SIAM J. Sci. Comput. 14, 1993) for vectors that are
   * arrays of the entries that a rank owns. A direction is made orthogonal to
   * all earlier ones at once, and once more (classical Gram-Schmidt, twice):
   * two reductions over all ranks per iteration, whatever their number, where
   * the modified algorithm takes one for each direction.
   */
  class FlexibleGmres
  {
  public:
    using Entries = std::vector<double>;

    /// Calculates y from x. Collective.
    using Operation = std::function<void(Entries &y, const Entries &x)>;

    /// Preconditions: calculates x from b, and the matrix times x, which may
    /// be at hand by then. Collective.
    using Preconditioner =
      std::function<void(Entries &x, Entries &product, const Entries &b)>;

    struct Result
    {
      unsigned int iterations = 0;
      bool         converged  = false;
    };

    /// Euclidean norm over all ranks. Collective.
    static double
    norm(const Entries &x, const MPI_Comm communicator);

    /// @p max_directions are kept before the method restarts.
    FlexibleGmres(const MPI_Comm     communicator,
                  const unsigned int max_directions);

    /**
     * Solves for @p x, which starts from zero, until the norm of the residual
     * is at most @p tolerance. A residual that is not finite ends the iteration.
     * Collective.
     */
    Result
    solve(const Operation      &matrix,
          const Preconditioner &preconditioner,
          Entries              &x,
          const Entries        &b,
          const double          tolerance,
          const unsigned int    max_iterations) const;

  private:
    struct Basis;

    const MPI_Comm     communicator;
    const unsigned int max_directions;
  };
} // namespace stickslip

#endif
