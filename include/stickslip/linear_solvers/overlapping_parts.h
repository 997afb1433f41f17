#ifndef stickslip_linear_solvers_overlapping_parts_h
#define stickslip_linear_solvers_overlapping_parts_h

#include <stickslip/base/types.h>

#include <stickslip/linear_solvers/factorization/local_factorization.h>
#include <stickslip/linear_solvers/multigrid/block_rows.h>

#include <vector>

namespace stickslip
{
  /**
   * Approximate solves of a saddle point matrix [A C; B -E] that is too large
   * to be factorised as one: restricted additive Schwarz (Cai and Sarkis, SIAM
   * J. Sci. Comput. 21, 1999). Each rank cuts its rows into parts of bounded
   * size. A part is solved with everything next to it, of other ranks as well,
   * and sets its own unknowns. With a multiplier all displacements that it
   * touches are in the part: no row of B is cut, and multipliers that are
   * independent in the whole are so in the part.
   */
  class OverlappingParts
  {
  public:
    /// @p largest: rows of a part without its surroundings, about.
    explicit OverlappingParts(const unsigned int largest);

    ~OverlappingParts();

    /// Frees the factors.
    void
    clear();

    /**
     * @p is_multiplier, by owned row: which rows are those of multipliers.
     * Parts are chosen for each matrix, since what is next to each other
     * depends on which contacts are closed. Returns the most severe error of
     * all parts, the same on all ranks. Collective.
     */
    [[nodiscard]] FactorizationError
    factorise(const LA::SparseMatrix  &matrix,
              const std::vector<bool> &is_multiplier);

    /// x = an approximate solution for @p b. Collective.
    void
    solve(LA::Vector &x, const LA::Vector &b) const;

  private:
    struct Part
    {
      std::vector<unsigned int> rows; ///< local ones, its own ones first
      unsigned int              n_own = 0;
      LocalFactorization        factors;
    };

    /// The rows that this rank sees, by local numbers.
    struct Rows;

    const unsigned int        largest;
    NodeSpace                 space;   ///< each row is a node
    std::vector<unsigned int> part_of; ///< by owned row
    unsigned int              n_parts = 0;
    std::vector<Part>         parts;

    /// Own rows, those next to them, and what multipliers among these touch.
    Rows
    see_rows(const LA::SparseMatrix  &matrix,
             const std::vector<bool> &is_multiplier);

    /// Neighbours come into the same part.
    void
    choose_parts(const LA::SparseMatrix &matrix);

    /// Own rows of each part.
    void
    start_parts();

    /// Adds what is next to the own rows of a part. @p place is `outside`
    /// everywhere, and is so again afterwards.
    void
    add_surroundings(const Rows                &rows,
                     std::vector<unsigned int> &place,
                     Part                      &part) const;

    FactorizationError
    factorise_part(const Rows                &rows,
                   std::vector<unsigned int> &place,
                   Part                      &part) const;
  };
} // namespace stickslip

#endif
