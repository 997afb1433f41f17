#ifndef stickslip_linear_solvers_neighbour_product_h
#define stickslip_linear_solvers_neighbour_product_h

#include <stickslip/base/types.h>

#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * Products with a distributed matrix in which a rank waits for its neighbours
   * only. The matrix's own vmult has a barrier over all ranks in each exchange,
   * and Tvmult two. Vectors are arrays of the entries that a rank owns.
   *
   * start() and finish_add() are apart, so that the messages of several
   * matrices are on their way at a time. All objects have to be used in the
   * same order on all ranks.
   */
  class NeighbourProduct
  {
  public:
    /// Takes the exchange that @p matrix was made with. The matrix must outlive
    /// this object and keep its sparsity. Without communication.
    void
    reinit(const LA::SparseMatrix &matrix);

    /// Sends what other ranks need of @p x. Collective.
    void
    start(const double *x) const;

    /// y += A x, where @p x is that of start(), unchanged. Collective.
    void
    finish_add(double *y, const double *x) const;

    /// The same where all but @p rows of A x are zero. Collective.
    void
    finish_add(double *y, const double *x, const std::vector<int> &rows) const;

    /// The owned rows that have an entry where @p x, that of start(), is not
    /// zero. Collective.
    std::vector<int>
    rows_that_see(const double *x) const;

    /// y += A^T x. Collective.
    void
    add_transposed(double *y, const double *x) const;

  private:
    /// What is exchanged with one rank.
    struct Message
    {
      int                 rank;
      std::vector<int>    entries; ///< owned ones, or local columns
      std::vector<double> buffer;
    };

    const LA::SparseMatrix      *matrix       = nullptr;
    MPI_Comm                     communicator = MPI_COMM_SELF;
    bool                         has_exchange = false;
    mutable std::vector<Message> needed_elsewhere; ///< owned entries of x
    mutable std::vector<Message> needed_here;      ///< columns
    /// Columns that are owned, and the entries of x that they are.
    std::vector<std::pair<int, int>> owned_columns;
    mutable std::vector<double>      columns;
    mutable std::vector<MPI_Request> requests;

    void
    exchange(std::vector<Message> &sent, std::vector<Message> &received) const;

    void
    wait() const;

    /// Waits for what start() exchanges: @p x by local columns.
    const double *
    receive(const double *x) const;
  };
} // namespace stickslip

#endif
