#include <stickslip/linear_solvers/factorization/distributed_factorization.h>

#include <deal.II/base/mpi.h>

#include <Amesos_Klu.h>
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



    std::unique_ptr<Amesos_BaseSolver>
    make_solver(const DirectLibrary         library,
                const int                   supplement,
                const Epetra_LinearProblem &problem)
    {
      if (library == DirectLibrary::klu)
        return std::make_unique<Amesos_Klu>(problem);
      AssertThrow(library == DirectLibrary::mumps,
                  ExcMessage("Not a library for distributed matrices."));
      auto solver = std::make_unique<Amesos_Mumps>(problem);
      solver->SetICNTL(14, supplement);
      return solver;
    }
  } // namespace



  struct DistributedFactorization::Factors
  {
    Factors(const DirectLibrary     library,
            const int               supplement,
            const LA::SparseMatrix &matrix)
      : communicator(matrix.get_mpi_communicator())
    {
      problem.SetOperator(
        const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
      solver = make_solver(library, supplement, problem);
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
    solve(LA::Vector &x, const LA::Vector &b)
    {
      const SilentErrorStream silence;
      problem.SetLHS(&x.trilinos_vector());
      problem.SetRHS(const_cast<Epetra_MultiVector *>(
        static_cast<const Epetra_MultiVector *>(&b.trilinos_vector())));
      return error(solver->Solve());
    }

  private:
    const MPI_Comm                     communicator;
    Epetra_LinearProblem               problem;
    std::unique_ptr<Amesos_BaseSolver> solver;

    /// What the last call meant, from its return code on this rank. MUMPS may
    /// run on some of the ranks only, rank 0 among them; Amesos calls all of
    /// its errors singular, or forgets them.
    FactorizationError
    error(const int code) const
    {
      const bool is_root =
        dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
      auto *const mumps     = dynamic_cast<Amesos_Mumps *>(solver.get());
      const bool  has_infog = is_root && mumps != nullptr;
      // what rank 0 knows, and how many ranks failed
      const std::vector<int> seen{has_infog ? mumps->GetINFOG()[0] : 0,
                                  has_infog ? mumps->GetINFOG()[1] : 0,
                                  is_root ? code : 0,
                                  code != 0 ? 1 : 0};
      std::vector<int> sums(seen.size());
      dealii::Utilities::MPI::sum(seen, communicator, sums);
      FactorizationError result =
        mumps != nullptr ? mumps_error(sums[0], sums[1]) : klu_error(sums[2]);
      if (!result && sums[3] > 0)
        result.kind = FactorizationError::Kind::other;
      return result;
    }
  };



  DistributedFactorization::DistributedFactorization(
    const DirectLibrary library,
    const int           supplement)
    : library(library)
    , supplement(supplement)
  {}



  DistributedFactorization::~DistributedFactorization() = default;



  void
  DistributedFactorization::clear()
  {
    factors.reset();
  }



  FactorizationError
  DistributedFactorization::factorise(const LA::SparseMatrix &matrix)
  {
    while (true)
      {
        factors.reset();
        factors = std::make_unique<Factors>(library, supplement, matrix);
        const FactorizationError error = factors->factorise();
        if (error.kind != FactorizationError::Kind::workspace ||
            supplement >= largest_supplement)
          return error;
        supplement = std::max(2 * supplement, usual_supplement);
      }
  }



  FactorizationError
  DistributedFactorization::solve(LA::Vector &x, const LA::Vector &b) const
  {
    Assert(factors != nullptr, ExcMessage("There are no factors."));
    return factors->solve(x, b);
  }
} // namespace stickslip
