#include <stickslip/linear_solvers/factorization/distributed_factorization.h>

#include <deal.II/base/mpi.h>

#include <Amesos_Mumps.h>
#include <Epetra_LinearProblem.h>

#include <algorithm>
#include <iostream>
#include <streambuf>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Supplement (in per cent) above which more does not help.
    constexpr int largest_supplement = 5000;



    /// Amesos writes what fails to the error stream, from all ranks; the caller
    /// receives it as data instead. Not for several threads.
    class SilentErrorStream
    {
    public:
      SilentErrorStream()
        : buffer(std::cerr.rdbuf(nullptr))
      {}

      ~SilentErrorStream()
      {
        std::cerr.rdbuf(buffer); // which also resets the error flags
      }

      SilentErrorStream(const SilentErrorStream &) = delete;

    private:
      std::streambuf *const buffer;
    };
  } // namespace



  struct DistributedFactorization::Factors
  {
    Factors(const LA::SparseMatrix &matrix,
            const Ordering          ordering,
            const int               supplement)
      : communicator(matrix.get_mpi_communicator())
    {
      problem.SetOperator(
        const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
      solver = std::make_unique<Amesos_Mumps>(problem);
      if (ordering == Ordering::minimum_fill)
        solver->SetICNTL(7, 2);
      solver->SetICNTL(14, supplement);
    }

    FactorizationError
    factorise()
    {
      const SilentErrorStream silence;
      int                     code = solver->SymbolicFactorization();
      if (code == 0)
        code = solver->NumericFactorization();
      return error(code);
    }

    FactorizationError
    refactorise()
    {
      const SilentErrorStream silence;
      return error(solver->NumericFactorization());
    }

    FactorizationError
    solve(LA::Vector &x, const LA::Vector &b)
    {
      const SilentErrorStream silence;
      problem.SetLHS(&x.trilinos_vector());
      problem.SetRHS(const_cast<Epetra_MultiVector *>(
        static_cast<const Epetra_MultiVector *>(&b.trilinos_vector())));
      return error(solver->Solve());
    }

  private:
    const MPI_Comm                communicator;
    Epetra_LinearProblem          problem;
    std::unique_ptr<Amesos_Mumps> solver;

    /// What the last call meant, from its return code on this rank. MUMPS may
    /// run on some of the ranks only, rank 0 among them; Amesos calls all of
    /// its errors singular, or forgets them.
    FactorizationError
    error(const int code) const
    {
      const bool is_root =
        dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
      // what rank 0 knows, and how many ranks failed
      const std::vector<int> seen{is_root ? solver->GetINFOG()[0] : 0,
                                  is_root ? solver->GetINFOG()[1] : 0,
                                  code != 0 ? 1 : 0};
      std::vector<int> sums(seen.size());
      dealii::Utilities::MPI::sum(seen, communicator, sums);
      FactorizationError result = mumps_error(sums[0], sums[1]);
      if (!result && sums[2] > 0)
        result.kind = FactorizationError::Kind::other;
      return result;
    }
  };



  DistributedFactorization::DistributedFactorization(const int supplement)
    : supplement(supplement)
  {}



  DistributedFactorization::~DistributedFactorization() = default;



  void
  DistributedFactorization::clear()
  {
    factors.reset();
  }



  FactorizationError
  DistributedFactorization::factorise(const LA::SparseMatrix &matrix,
                                      const Ordering          ordering)
  {
    while (true)
      {
        factors.reset();
        factors = std::make_unique<Factors>(matrix, ordering, supplement);
        const FactorizationError error = factors->factorise();
        if (error.kind != FactorizationError::Kind::workspace ||
            supplement >= largest_supplement)
          return error;
        supplement = std::max(2 * supplement, usual_supplement);
      }
  }



  FactorizationError
  DistributedFactorization::refactorise()
  {
    if (factors != nullptr)
      return factors->refactorise();
    FactorizationError nothing_there;
    nothing_there.kind = FactorizationError::Kind::other;
    return nothing_there;
  }



  FactorizationError
  DistributedFactorization::solve(LA::Vector &x, const LA::Vector &b) const
  {
    Assert(factors != nullptr, ExcMessage("There are no factors."));
    return factors->solve(x, b);
  }
} // namespace stickslip
