#include <stickslip/base/types.h>

namespace stickslip
{
  namespace LA
  {
    void
    RowAdder::add(const types::global_dof_index               row,
                  const std::vector<types::global_dof_index> &columns,
                  const std::vector<double>                  &values,
                  const double                                weight)
    {
      using Index           = TrilinosWrappers::types::int_type;
      const auto &epetra    = matrix.trilinos_matrix();
      const int   local_row = epetra.LRID(static_cast<Index>(row));
      if (local_row < 0) // of another rank
        {
          std::vector<double> weighted(values);
          for (double &value : weighted)
            value *= weight;
          matrix.add(row, columns, weighted, false);
          return;
        }
      int       n_entries = 0;
      double   *entries   = nullptr;
      int      *stored    = nullptr;
      const int error =
        epetra.ExtractMyRowView(local_row, n_entries, entries, stored);
      AssertThrow(error == 0, ExcMessage("The row is not stored here."));
      for (int k = 0; k < n_entries; ++k)
        positions[stored[k]] = k;
      for (unsigned int k = 0; k < columns.size(); ++k)
        {
          const int column   = epetra.LCID(static_cast<Index>(columns[k]));
          const int position = column < 0 ? n_entries : positions[column];
          AssertThrow(position < n_entries && stored[position] == column,
                      ExcMessage("The sparsity lacks an entry."));
          entries[position] += weight * values[k];
        }
    }



    void
    AlgebraicMultigrid::initialize(const SparseMatrix &matrix,
                                   const unsigned int  n_components,
                                   const unsigned int  n_vectors,
                                   const double       *near_null_space)
    {
      Teuchos::ParameterList list;
      list.set("ML output", 0);
      list.set("max levels", 10);
      list.set("increasing or decreasing", "increasing");
      list.set("prec type", "MGV");
      list.set("PDE equations", static_cast<int>(n_components));
      list.set("aggregation: type", "Uncoupled");
      list.set("aggregation: threshold", 0.);
      list.set("aggregation: damping factor", 4. / 3.);
      list.set("eigen-analysis: type", "cg");
      // ML's own sweeps are three times as fast as those of Ifpack
      list.set("smoother: type", "ML symmetric Gauss-Seidel");
      list.set("smoother: sweeps", 1);
      list.set("smoother: damping factor", 1.);
      list.set("smoother: pre or post", "both");
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", 1000);
      if (n_vectors > 0)
        {
          list.set("null space: type", "pre-computed");
          list.set("null space: dimension", static_cast<int>(n_vectors));
          // ML only reads them
          list.set("null space: vectors",
                   const_cast<double *>(near_null_space));
          list.set("null space: add default vectors", false);
        }
      hierarchy.initialize(matrix, list);
    }
  } // namespace LA
} // namespace stickslip
