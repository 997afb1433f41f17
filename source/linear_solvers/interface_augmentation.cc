#include <stickslip/linear_solvers/interface_augmentation.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Columns and values of an owned row that are not zero.
    struct StoredRow
    {
      std::vector<types::global_dof_index> columns;
      std::vector<double>                  values;

      void
      read(const LA::SparseMatrix &matrix, const types::global_dof_index row)
      {
        columns.clear();
        values.clear();
        LA::visit_row(matrix, row, [&](const auto column, const double value) {
          if (value != 0.)
            {
              columns.push_back(column);
              values.push_back(value);
            }
        });
      }
    };
  } // namespace



  void
  InterfaceAugmentation::reinit(const LA::BlockSparseMatrix  &system,
                                const BlockSystemDescription &description,
                                const double                  factor)
  {
    matrix  = &system;
    inverse = description.regularization;
    product.reinit(system.block(1, 0));
    for (const auto i : inverse.locally_owned_elements())
      {
        const double D = inverse(i) / factor +
                         std::max(0., -system.block(1, 1).diag_element(i));
        inverse(i) = D > 0. ? 1. / D : 0.;
      }
    inverse.compress(VectorOperation::insert);
  }



  void
  InterfaceAugmentation::build_matrix(LA::SparseMatrix &added) const
  {
    const LA::SparseMatrix &B = matrix->block(1, 0);
    const IndexSet owned = matrix->block(0, 0).locally_owned_range_indices();
    StoredRow      row;

    // hardly any row has entries
    LA::SparsityPattern pattern(owned,
                                owned,
                                matrix->block(0, 0).get_mpi_communicator(),
                                0);
    for (const auto i : inverse.locally_owned_elements())
      if (inverse(i) > 0.)
        {
          row.read(B, i);
          for (const auto j : row.columns)
            pattern.add_entries(j, row.columns.begin(), row.columns.end());
        }
    pattern.compress();
    added.reinit(pattern);

    std::vector<double> product;
    for (const auto i : inverse.locally_owned_elements())
      if (inverse(i) > 0.)
        {
          row.read(B, i);
          for (unsigned int k = 0; k < row.columns.size(); ++k)
            {
              product = row.values;
              for (double &value : product)
                value *= row.values[k] * inverse(i);
              added.add(row.columns[k], row.columns, product, false);
            }
        }
    added.compress(VectorOperation::add);
  }



  LA::Vector
  InterfaceAugmentation::added_stiffness() const
  {
    LA::Vector stiffness(inverse);
    for (const auto i : inverse.locally_owned_elements())
      {
        double square = 0.;
        LA::visit_row(matrix->block(1, 0),
                      i,
                      [&](const auto, const double value) {
                        square += value * value;
                      });
        stiffness(i) = square * inverse(i);
      }
    stiffness.compress(VectorOperation::insert);
    return stiffness;
  }



  void
  InterfaceAugmentation::add_to(OwnedEntries &entries) const
  {
    const unsigned int  n_multipliers = inverse.locally_owned_size();
    const double *const multipliers =
      entries.data() + entries.size() - n_multipliers;
    const double *const factors = inverse.begin();
    scaled.resize(n_multipliers);
    for (unsigned int i = 0; i < n_multipliers; ++i)
      scaled[i] = factors[i] * multipliers[i];
    product.add_transposed(entries.data(), scaled.data());
  }
} // namespace stickslip
