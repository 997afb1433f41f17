#ifndef stickslip_linear_solvers_factorization_local_factorization_h
#define stickslip_linear_solvers_factorization_local_factorization_h

#include <stickslip/linear_solvers/factorization/factorization_error.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * LU factors of a matrix on one rank, by UMFPACK. Unlike deal.II's
   * SparseDirectUMFPACK it says what went wrong, and it keeps no copy of a
   * second matrix type.
   */
  class LocalFactorization
  {
  public:
    LocalFactorization();

    ~LocalFactorization();

    LocalFactorization(LocalFactorization &&);

    LocalFactorization &
    operator=(LocalFactorization &&);

    /**
     * Factorises the square matrix whose row i has @p values[k] in
     * @p columns[k] for k from @p row_begins[i] to before @p row_begins[i+1],
     * in increasing columns without repetition. Not collective.
     */
    [[nodiscard]] FactorizationError
    factorise(std::vector<long>   &&row_begins,
              std::vector<long>   &&columns,
              std::vector<double> &&values);

    /// x = A^-1 b; both have the matrix's size. Not collective.
    [[nodiscard]] FactorizationError
    solve(std::vector<double> &x, const std::vector<double> &b) const;

  private:
    struct Factors;

    std::unique_ptr<Factors> factors;
  };
} // namespace stickslip

#endif
