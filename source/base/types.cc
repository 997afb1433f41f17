#include <stickslip/base/types.h>

namespace stickslip
{
  namespace LA
  {
    void
    RowAdder::set_columns(
      const std::vector<types::global_dof_index> &new_columns)
    {
      columns = new_columns;
      local_columns.clear();
      for (const auto column : columns)
        local_columns.push_back(matrix.trilinos_matrix().LCID(
          static_cast<TrilinosWrappers::types::int_type>(column)));
    }



    void
    RowAdder::add(const types::global_dof_index row,
                  const std::vector<double>    &values,
                  const double                  weight)
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
      for (unsigned int k = 0; k < local_columns.size(); ++k)
        {
          const int column   = local_columns[k];
          const int position = column < 0 ? n_entries : positions[column];
          AssertThrow(position < n_entries && stored[position] == column,
                      ExcMessage("The sparsity lacks an entry."));
          entries[position] += weight * values[k];
        }
    }
  } // namespace LA
} // namespace stickslip
