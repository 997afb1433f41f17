#ifndef stickslip_linear_solvers_direct_solver_h
#define stickslip_linear_solvers_direct_solver_h

#include <stickslip/linear_solvers/factorization/distributed_factorization.h>
#include <stickslip/linear_solvers/linear_solver.h>

#include <vector>

namespace stickslip
{
  /**
   * MUMPS through Amesos on the whole system. The blocks are copied into one
   * matrix whose rows are, on every rank, its displacements followed by its
   * multipliers.
   */
  class DirectSolver : public LinearSolver
  {
  public:
    void
    setup(const LA::BlockSparseMatrix &matrix,
          const SystemDescriber       &describe) override;

    LinearSolve
    solve(LA::BlockVector       &x,
          const LA::BlockVector &b,
          const double           sufficient) override;

  private:
    /// Where a rank's rows of each block start in the merged numbering.
    struct MergedNumbering
    {
      std::vector<std::vector<types::global_dof_index>>
        block_starts; ///< [block][rank]
      std::vector<std::vector<types::global_dof_index>> merged_starts;

      types::global_dof_index
      operator()(const unsigned int            block,
                 const types::global_dof_index i) const;
    };

    unsigned int             layout = 0; ///< of `merged`, if it is not empty
    LA::SparseMatrix         merged;
    MergedNumbering          numbering;
    DistributedFactorization factorization;

    void
    number_rows(const LA::BlockSparseMatrix &matrix);

    void
    make_pattern(const LA::BlockSparseMatrix &matrix);

    void
    fill(const LA::BlockSparseMatrix &matrix);

    /// Calls visit(merged row, merged columns, values) for the owned rows.
    template <typename Visitor>
    void
    visit_rows(const LA::BlockSparseMatrix &matrix, const Visitor &visit) const;
  };
} // namespace stickslip

#endif
