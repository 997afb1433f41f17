#include <stickslip/linear_solvers/neighbour_product.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_MpiDistributor.h>

#include <algorithm>
#include <map>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Not one of deal.II's, Trilinos', MUMPS' or our other messages.
    constexpr int product_tag = 7104;



    /// Calls visit(row, number of entries, values, local columns) for an owned
    /// row.
    template <typename Visitor>
    void
    visit_row(const Epetra_CrsMatrix &matrix,
              const int               row,
              const Visitor          &visit)
    {
      int       n       = 0;
      double   *values  = nullptr;
      int      *columns = nullptr;
      const int error   = matrix.ExtractMyRowView(row, n, values, columns);
      AssertThrow(error == 0, ExcMessage("A row is not stored."));
      visit(row, n, values, columns);
    }



    /// The same for all owned rows.
    template <typename Visitor>
    void
    visit_rows(const Epetra_CrsMatrix &matrix, const Visitor &visit)
    {
      for (int row = 0; row < matrix.NumMyRows(); ++row)
        visit_row(matrix, row, visit);
    }



    /// Visitor of rows that adds A x to @p y.
    auto
    add_product(double *const y, const double *const x)
    {
      return [=](const int           row,
                 const int           n,
                 const double *const values,
                 const int *const    columns) {
        double sum = 0.;
        for (int k = 0; k < n; ++k)
          sum += values[k] * x[columns[k]];
        y[row] += sum;
      };
    }
  } // namespace



  void
  NeighbourProduct::reinit(const LA::SparseMatrix &A)
  {
    matrix       = &A;
    communicator = A.get_mpi_communicator();
    needed_elsewhere.clear();
    needed_here.clear();
    owned_columns.clear();
    const Epetra_Import *const import = A.trilinos_matrix().Importer();
    has_exchange                      = import != nullptr;
    if (!has_exchange)
      return;
    columns.resize(A.trilinos_matrix().NumMyCols());
    for (int i = 0; i < import->NumSameIDs(); ++i)
      owned_columns.emplace_back(i, i);
    for (int i = 0; i < import->NumPermuteIDs(); ++i)
      owned_columns.emplace_back(import->PermuteToLIDs()[i],
                                 import->PermuteFromLIDs()[i]);
    // in the order in which the other rank expects them
    std::map<int, std::vector<int>> exported;
    for (int i = 0; i < import->NumExportIDs(); ++i)
      exported[import->ExportPIDs()[i]].push_back(import->ExportLIDs()[i]);
    for (auto &[rank, entries] : exported)
      needed_elsewhere.push_back({rank, std::move(entries), {}});
    const auto *const plan =
      dynamic_cast<const Epetra_MpiDistributor *>(import->DistributorPtr());
    if (plan == nullptr) // on one rank
      return;
    const int *next = import->RemoteLIDs();
    for (int k = 0; k < plan->NumReceives(); ++k)
      {
        const int *const end = next + plan->LengthsFrom()[k];
        needed_here.push_back(
          {plan->ProcsFrom()[k], std::vector<int>(next, end), {}});
        next = end;
      }
    AssertThrow(next == import->RemoteLIDs() + import->NumRemoteIDs(),
                ExcMessage("The exchange of columns is not understood."));
  }



  void
  NeighbourProduct::exchange(std::vector<Message> &sent,
                             std::vector<Message> &received) const
  {
    requests.clear();
    const auto post = [&](const auto function, Message &message) {
      requests.emplace_back();
      const int error = function(message.buffer.data(),
                                 message.buffer.size(),
                                 MPI_DOUBLE,
                                 message.rank,
                                 product_tag,
                                 communicator,
                                 &requests.back());
      AssertThrowMPI(error);
    };
    for (Message &message : received)
      {
        message.buffer.resize(message.entries.size());
        post(MPI_Irecv, message);
      }
    for (Message &message : sent)
      post(MPI_Isend, message);
  }



  void
  NeighbourProduct::wait() const
  {
    const int error =
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    AssertThrowMPI(error);
  }



  void
  NeighbourProduct::start(const double *const x) const
  {
    for (Message &message : needed_elsewhere)
      {
        message.buffer.clear();
        for (const int i : message.entries)
          message.buffer.push_back(x[i]);
      }
    exchange(needed_elsewhere, needed_here);
  }



  const double *
  NeighbourProduct::receive(const double *const x) const
  {
    if (!has_exchange)
      return x;
    for (const auto &[column, entry] : owned_columns)
      columns[column] = x[entry];
    wait();
    for (const Message &message : needed_here)
      for (unsigned int k = 0; k < message.entries.size(); ++k)
        columns[message.entries[k]] = message.buffer[k];
    return columns.data();
  }



  void
  NeighbourProduct::finish_add(double *const y, const double *const x) const
  {
    visit_rows(matrix->trilinos_matrix(), add_product(y, receive(x)));
  }



  void
  NeighbourProduct::finish_add(double *const           y,
                               const double *const     x,
                               const std::vector<int> &rows) const
  {
    const auto add = add_product(y, receive(x));
    for (const int row : rows)
      visit_row(matrix->trilinos_matrix(), row, add);
  }



  std::vector<int>
  NeighbourProduct::rows_that_see(const double *const x) const
  {
    std::vector<int>    rows;
    const double *const of_columns = receive(x);
    visit_rows(matrix->trilinos_matrix(),
               [&](const int row,
                   const int n,
                   const double *const,
                   const int *const numbers) {
                 if (std::any_of(numbers, numbers + n, [&](const int column) {
                       return of_columns[column] != 0.;
                     }))
                   rows.push_back(row);
               });
    return rows;
  }



  void
  NeighbourProduct::add_transposed(double *const y, const double *const x) const
  {
    std::fill(columns.begin(), columns.end(), 0.);
    double *const sums = has_exchange ? columns.data() : y;
    visit_rows(matrix->trilinos_matrix(),
               [&](const int           row,
                   const int           n,
                   const double *const values,
                   const int *const    numbers) {
                 for (int k = 0; k < n; ++k)
                   sums[numbers[k]] += values[k] * x[row];
               });
    if (!has_exchange)
      return;
    for (Message &message : needed_here)
      {
        message.buffer.clear();
        for (const int column : message.entries)
          message.buffer.push_back(columns[column]);
      }
    exchange(needed_here, needed_elsewhere);
    for (const auto &[column, entry] : owned_columns)
      y[entry] += columns[column];
    wait();
    for (const Message &message : needed_elsewhere)
      for (unsigned int k = 0; k < message.entries.size(); ++k)
        y[message.entries[k]] += message.buffer[k];
  }
} // namespace stickslip
