#ifndef stickslip_linear_solvers_interface_solver_h
#define stickslip_linear_solvers_interface_solver_h

#include <stickslip/base/block_system.h>

#include <stickslip/linear_solvers/block_product.h>
#include <stickslip/linear_solvers/factorization/distributed_factorization.h>
#include <stickslip/linear_solvers/overlapping_parts.h>

#include <array>
#include <vector>

namespace stickslip
{
  /**
   * Solves on the contact interface: all multipliers, all displacements on
   * which one of them acts now, and those of the surfaces that the pattern of
   * the matrix couples with these, their neighbours above all. (Most of what
   * may come into contact is open in most problems, where multigrid is enough;
   * without the margin a partly open interface of two cubes takes a quarter
   * more iterations.) Its matrix is that part of [A C; B -E],
   * factorised by MUMPS, so that nothing has to be guessed of a Schur
   * complement. It is a surface and small beside the bodies; where it is too
   * large all the same, it is solved in overlapping parts.
   */
  class InterfaceSolver
  {
  public:
    /// @p largest: unknowns up to which the interface is factorised as one, and of
    /// a part of a larger interface.
    explicit InterfaceSolver(const unsigned int largest);

    /// Finds out which unknowns of @p matrix belong to the interface.
    /// Multipliers that are greater than zero in @p also_acting count as
    /// acting. Returns on all ranks whether these are others than after the
    /// last call, as always with a @p new_layout, which the first matrix has.
    /// Collective.
    bool
    determine_unknowns(const LA::BlockSparseMatrix &matrix,
                       const bool                   new_layout,
                       const LA::Vector            *also_acting = nullptr);

    /// Factorises the interface of @p matrix, which determine_unknowns() has
    /// seen. Throws NoConvergence if it cannot be factorised. Collective.
    void
    factorise(const LA::BlockSparseMatrix &matrix);

    /// One where an owned unknown is in the interface, zero elsewhere, for
    /// @p n owned ones.
    OwnedEntries
    marks(const unsigned int n) const;

    /// Writes the solution for the part of @p residual in the interface into
    /// the unknowns of the interface of @p x. Collective.
    void
    solve(OwnedEntries &x, const OwnedEntries &residual);

    /// Unknowns of the interface that has been factorised, over all ranks.
    types::global_dof_index
    n_unknowns() const
    {
      return interface.m();
    }

  private:
    /// Where an owned interface row stands in the block system.
    struct Row
    {
      unsigned int            block;
      types::global_dof_index index; ///< in its block
      unsigned int            entry; ///< among the owned entries

      bool
      operator==(const Row &other) const
      {
        return block == other.block && index == other.index;
      }
    };

    const unsigned int        largest;
    std::vector<Row>          surface; ///< owned rows that may touch contact
    std::vector<Row>          rows;    ///< those of the interface, in order
    types::global_dof_index   first;   ///< number of rows[0] in the interface
    std::array<LA::Vector, 2> numbers; ///< interface number + 1, ghosted; other
                                       ///< marks in rows_near_contact()
    /// The rows are others than those of the matrix `interface`.
    bool is_renumbered = true;

    LA::SparseMatrix         interface;
    LA::Vector               rhs, solution;
    DistributedFactorization factorization; ///< of the whole interface
    OverlappingParts         parts;         ///< if it is larger than `largest`

    /// What is true of the layout: `surface` and the ghosts of `numbers`.
    void
    find_surface(const LA::BlockSparseMatrix &matrix);

    /// The rows of the interface. Collective; `numbers` is no longer what it
    /// says until number_rows().
    std::vector<Row>
    rows_near_contact(const LA::BlockSparseMatrix &matrix,
                      const LA::Vector            *also_acting);

    /// numbers[block] = value(k) for the unknown of row k, else zero.
    /// Collective.
    template <typename Value>
    void
    set_numbers(const unsigned int      block,
                const std::vector<Row> &of_rows,
                const Value            &value);

    /// Collective.
    void
    number_rows(const MPI_Comm communicator);

    void
    make_pattern(const LA::BlockSparseMatrix &matrix);

    /// The rows are those that the interface has been factorised with, and its
    /// pattern has all entries of @p matrix that are not zero there: nothing
    /// has to be analysed again. Collective.
    bool
    has_pattern_of(const LA::BlockSparseMatrix &matrix) const;

    void
    fill(const LA::BlockSparseMatrix &matrix);

    bool
    is_large() const
    {
      return interface.m() > largest;
    }

    /// Calls visit(interface column, value) for the entries of an owned row.
    template <typename Visitor>
    void
    visit_interface_row(const LA::BlockSparseMatrix &matrix,
                        const Row                   &row,
                        const Visitor               &visit) const;
  };
} // namespace stickslip

#endif
