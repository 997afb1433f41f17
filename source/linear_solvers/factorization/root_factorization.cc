#include <stickslip/linear_solvers/factorization/root_factorization.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Not one of deal.II's, Trilinos' or MUMPS' messages.
    constexpr int message_tag = 7105;



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
    parts.clear();
    int n_rows = 0;
    for (unsigned int rank = 0; rank < gathered.size(); ++rank)
      if (const int n = gathered[rank].size(); n > 0)
        {
          parts.push_back({rank, n_rows, n});
          n_rows += n;
        }
    all_b.resize(n_rows);
    FactorizationError error;
    if (!gathered.empty())
      error = factorise_all(gathered, factors);
    return worst_of(error, communicator);
  }



  void
  RootFactorization::solve(std::vector<double>       &x,
                           const std::vector<double> &b) const
  {
    x.resize(b.size());
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      solve_on_root(x, b);
    else if (!b.empty())
      {
        send(b.data(), b.size(), 0);
        receive(x.data(), x.size(), 0);
      }
  }



  void
  RootFactorization::solve_on_root(std::vector<double>       &x,
                                   const std::vector<double> &b) const
  {
    for (const auto &[rank, begin, n] : parts)
      if (rank == 0)
        std::copy_n(b.begin(), n, all_b.begin());
      else
        receive(all_b.data() + begin, n, rank);
    if (factors.solve(all_x, all_b))
      all_x.assign(all_b.size(), std::numeric_limits<double>::quiet_NaN());
    for (const auto &[rank, begin, n] : parts)
      if (rank == 0)
        std::copy_n(all_x.begin(), n, x.begin());
      else
        send(all_x.data() + begin, n, rank);
  }



  void
  RootFactorization::send(const double      *values,
                          const int          n,
                          const unsigned int rank) const
  {
    const int error =
      MPI_Send(values, n, MPI_DOUBLE, rank, message_tag, communicator);
    AssertThrowMPI(error);
  }



  void
  RootFactorization::receive(double            *values,
                             const int          n,
                             const unsigned int rank) const
  {
    const int error = MPI_Recv(values,
                               n,
                               MPI_DOUBLE,
                               rank,
                               message_tag,
                               communicator,
                               MPI_STATUS_IGNORE);
    AssertThrowMPI(error);
  }
} // namespace stickslip
