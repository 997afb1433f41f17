#ifndef stickslip_base_types_h
#define stickslip_base_types_h

#include <deal.II/base/array_view.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/block_sparsity_pattern.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>
#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * Names of the distributed linear algebra objects. This is the only place
   * that says which backend stands behind them (today deal.II's Epetra-backed
   * Trilinos wrappers), so that a Tpetra-backed build needs a second version
   * of this file and nothing else.
   */
  namespace LA
  {
    using Vector               = TrilinosWrappers::MPI::Vector;
    using BlockVector          = TrilinosWrappers::MPI::BlockVector;
    using SparseMatrix         = TrilinosWrappers::SparseMatrix;
    using BlockSparseMatrix    = TrilinosWrappers::BlockSparseMatrix;
    using SparsityPattern      = TrilinosWrappers::SparsityPattern;
    using BlockSparsityPattern = TrilinosWrappers::BlockSparsityPattern;



    /// The numbers of the columns that owned rows have, by local column.
    inline ArrayView<const TrilinosWrappers::types::int_type>
    column_numbers(const SparseMatrix &matrix)
    {
      const auto                        &epetra  = matrix.trilinos_matrix();
      TrilinosWrappers::types::int_type *numbers = nullptr;
      epetra.ColMap().MyGlobalElementsPtr(numbers);
      return {numbers, static_cast<std::size_t>(epetra.NumMyCols())};
    }



    /**
     * Calls @p visit(local column, value) for all stored entries of the owned
     * row @p row, in the order of storage; see column_numbers().
     */
    template <typename Visitor>
    void
    visit_local_row(const SparseMatrix           &matrix,
                    const types::global_dof_index row,
                    const Visitor                &visit)
    {
      const auto &epetra = matrix.trilinos_matrix();
      const int   local_row =
        epetra.LRID(static_cast<TrilinosWrappers::types::int_type>(row));
      int       n_entries = 0;
      double   *values    = nullptr;
      int      *columns   = nullptr;
      const int error =
        epetra.ExtractMyRowView(local_row, n_entries, values, columns);
      AssertThrow(error == 0, ExcMessage("The row is not stored here."));
      for (int k = 0; k < n_entries; ++k)
        visit(static_cast<unsigned int>(columns[k]), values[k]);
    }



    /**
     * The same with the numbers of columns over all ranks. Use it in place of
     * the matrix's iterators: their end(row) searches for the next row that is
     * not empty, which makes a loop over a sparse block quadratic.
     */
    template <typename Visitor>
    void
    visit_row(const SparseMatrix           &matrix,
              const types::global_dof_index row,
              const Visitor                &visit)
    {
      const auto numbers = column_numbers(matrix);
      visit_local_row(
        matrix, row, [&](const unsigned int column, const double value) {
          visit(static_cast<types::global_dof_index>(numbers[column]), value);
        });
    }



    /// Entries that are stored in the owned row @p row.
    inline unsigned int
    row_length(const SparseMatrix &matrix, const types::global_dof_index row)
    {
      const auto &epetra = matrix.trilinos_matrix();
      return epetra.NumMyEntries(
        epetra.LRID(static_cast<TrilinosWrappers::types::int_type>(row)));
    }



    /// Entries of the longest owned row.
    inline unsigned int
    longest_row(const SparseMatrix &matrix)
    {
      return matrix.trilinos_matrix().MaxNumEntries();
    }



    /// Adds rows to a matrix. Owned ones go straight into its storage, which
    /// spares the search for each column.
    class RowAdder
    {
    public:
      /// @p matrix must outlive this object and keep its sparsity.
      explicit RowAdder(SparseMatrix &matrix)
        : matrix(matrix)
        , positions(matrix.trilinos_matrix().NumMyCols())
      {}

      /// Sets the columns of the rows that follow; one may occur several times.
      void
      set_columns(const std::vector<types::global_dof_index> &columns);

      /// Row @p row += @p weight times @p values in the columns, which must be
      /// in the sparsity.
      void
      add(const types::global_dof_index row,
          const std::vector<double>    &values,
          const double                  weight);

    private:
      SparseMatrix                        &matrix;
      std::vector<types::global_dof_index> columns;
      std::vector<int> local_columns; ///< negative: no row here has it
      std::vector<int> positions;     ///< of local columns in the present row
    };
  } // namespace LA

  /// Constraints on the degrees of freedom of a field.
  using Constraints = AffineConstraints<double>;
} // namespace stickslip

#endif
