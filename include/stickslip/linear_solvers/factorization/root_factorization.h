#ifndef stickslip_linear_solvers_factorization_root_factorization_h
#define stickslip_linear_solvers_factorization_root_factorization_h

#include <stickslip/linear_solvers/factorization/local_factorization.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace stickslip
{
  /**
   * LU factors, on rank 0, of a small matrix whose rows are distributed. A
   * solve takes one gather and one scatter.
   */
  class RootFactorization
  {
  public:
    /// A row by its columns (in any order, without repetition).
    struct Row
    {
      std::vector<long>   columns;
      std::vector<double> values;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &columns;
        archive &values;
      }
    };

    /// Factorises the matrix of the @p rows of all ranks, numbered rank after
    /// rank. Returns the same on all ranks. Collective.
    [[nodiscard]] FactorizationError
    factorise(const std::vector<Row> &rows, const MPI_Comm communicator);

    /// Solves for @p x, from the entries of @p b that this rank owns. If a solve
    /// fails, all of @p x is not a number. Collective.
    void
    solve(std::vector<double> &x, const std::vector<double> &b) const;

    /// Frees the factors.
    void
    clear();

  private:
    MPI_Comm                    communicator = MPI_COMM_SELF;
    LocalFactorization          factors;        ///< on rank 0
    std::vector<int>            n_rows, begins; ///< by rank, on rank 0
    mutable std::vector<double> all_x, all_b;
  };
} // namespace stickslip

#endif
