#ifndef stickslip_linear_solvers_factorization_root_factorization_h
#define stickslip_linear_solvers_factorization_root_factorization_h

#include <stickslip/linear_solvers/factorization/local_factorization.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace stickslip
{
  /**
   * LU factors, on rank 0, of a small matrix whose rows are distributed. A
   * solve takes a message from each other rank that has rows, and one back;
   * ranks without rows do not wait.
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
    /// The rows of a rank that has some.
    struct Part
    {
      unsigned int rank;
      int          begin, n_rows;
    };

    MPI_Comm                    communicator = MPI_COMM_SELF;
    LocalFactorization          factors; ///< these three on rank 0
    std::vector<Part>           parts;
    mutable std::vector<double> all_x, all_b;

    void
    solve_on_root(std::vector<double> &x, const std::vector<double> &b) const;

    void
    send(const double *values, const int n, const unsigned int rank) const;

    void
    receive(double *values, const int n, const unsigned int rank) const;
  };
} // namespace stickslip

#endif
