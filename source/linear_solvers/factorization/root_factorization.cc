#include <stickslip/linear_solvers/factorization/root_factorization.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Rows rank after rank.
    FactorizationError
    factorise_all(
      const std::vector<std::vector<RootFactorization::Row>> &rows_of_ranks,
      LocalFactorization                                     &factors)
    {
      std::vector<long>                    begins(1, 0), columns;
      std::vector<double>                  values;
      std::vector<std::pair<long, double>> entries;
      for (const auto &rows : rows_of_ranks)
        for (const RootFactorization::Row &row : rows)
          {
            entries.clear();
            for (std::size_t k = 0; k < row.columns.size(); ++k)
              entries.emplace_back(row.columns[k], row.values[k]);
            std::sort(entries.begin(), entries.end());
            for (const auto &[column, value] : entries)
              {
                columns.push_back(column);
                values.push_back(value);
              }
            begins.push_back(columns.size());
          }
      return factors.factorise(std::move(begins),
                               std::move(columns),
                               std::move(values));
    }
  } // namespace



  void
  RootFactorization::clear()
  {
    factors = LocalFactorization();
  }



  FactorizationError
  RootFactorization::factorise(const std::vector<Row> &rows,
                               const MPI_Comm          comm)
  {
    communicator        = comm;
    const auto gathered = Utilities::MPI::gather(communicator, rows, 0);
    n_rows.clear();
    begins.assign(1, 0);
    for (const auto &rows_of_rank : gathered)
      {
        n_rows.push_back(rows_of_rank.size());
        begins.push_back(begins.back() + n_rows.back());
      }
    FactorizationError error;
    if (!gathered.empty())
      error = factorise_all(gathered, factors);
    return worst_of(error, communicator);
  }



  void
  RootFactorization::solve(std::vector<double>       &x,
                           const std::vector<double> &b) const
  {
    const bool is_root = !n_rows.empty();
    if (is_root)
      all_b.resize(begins.back());
    int error = MPI_Gatherv(b.data(),
                            b.size(),
                            MPI_DOUBLE,
                            all_b.data(),
                            n_rows.data(),
                            begins.data(),
                            MPI_DOUBLE,
                            0,
                            communicator);
    AssertThrowMPI(error);
    if (is_root && factors.solve(all_x, all_b))
      all_x.assign(all_b.size(), std::numeric_limits<double>::quiet_NaN());
    x.resize(b.size());
    error = MPI_Scatterv(all_x.data(),
                         n_rows.data(),
                         begins.data(),
                         MPI_DOUBLE,
                         x.data(),
                         x.size(),
                         MPI_DOUBLE,
                         0,
                         communicator);
    AssertThrowMPI(error);
  }
} // namespace stickslip
