#ifndef stickslip_linear_solvers_multigrid_ordered_exchange_h
#define stickslip_linear_solvers_multigrid_ordered_exchange_h

#include <stickslip/linear_solvers/multigrid/node_space.h>

#include <vector>

namespace stickslip
{
  /**
   * Values at ghosts for sweeps that go over the ranks one after the other.
   * Each rank has its turn before some of its neighbours and after the others.
   * The order is a random one (the same in all runs), since with that only a
   * few ranks in a row wait for each other; in the order of their numbers all
   * might.
   */
  class OrderedExchange
  {
  public:
    enum class Neighbours
    {
      earlier,
      later
    };

    OrderedExchange() = default;

    /// Waits for messages that are under way.
    ~OrderedExchange();

    OrderedExchange(const OrderedExchange &) = delete;
    OrderedExchange &
    operator=(const OrderedExchange &) = delete;

    /// For vectors of @p space with its present ghosts.
    void
    reinit(const NodeSpace &space);

    /// Whether another rank's turn is before this one's.
    bool
    is_earlier(const unsigned int rank) const;

    /// When this rank has its turn, from 0, first of all, to 1: ranks with
    /// larger turns are later ones.
    double
    turn() const;

    /// Sends what some neighbours see of the owned values. Returns at once.
    void
    send(const std::vector<double> &x, const Neighbours to) const;

    /// Lets messages get on: MPI may send those above a few kilobytes only
    /// while it is called. To be called now and then in long work, or
    /// neighbours wait for its end.
    void
    progress() const;

    /// Waits for what some neighbours send, and writes it to the ghosts of @p
    /// x.
    void
    receive(std::vector<double> &x, const Neighbours from) const;

  private:
    struct Outgoing
    {
      unsigned int              rank;
      Neighbours                side;
      std::vector<unsigned int> unknowns;
      std::vector<double>       buffer;
      MPI_Request               request = MPI_REQUEST_NULL;
    };

    struct Incoming
    {
      unsigned int rank;
      Neighbours   side;
      unsigned int begin, end; ///< in vectors
    };

    MPI_Comm                      communicator = MPI_COMM_SELF;
    unsigned int                  my_rank      = 0;
    mutable std::vector<Outgoing> outgoing;
    std::vector<Incoming>         incoming;

    void
    finish_sending();
  };
} // namespace stickslip

#endif
