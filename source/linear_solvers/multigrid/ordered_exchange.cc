#include <stickslip/linear_solvers/multigrid/ordered_exchange.h>

#include <stickslip/base/mixed_bits.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <limits>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// Not one of deal.II's, Trilinos' or MUMPS' messages.
    constexpr int message_tag = 7103;
  } // namespace



  OrderedExchange::~OrderedExchange()
  {
    finish_sending();
  }



  void
  OrderedExchange::finish_sending()
  {
    for (Outgoing &message : outgoing)
      MPI_Wait(&message.request, MPI_STATUS_IGNORE);
  }



  bool
  OrderedExchange::is_earlier(const unsigned int rank) const
  {
    return mixed_bits(rank) < mixed_bits(my_rank);
  }



  double
  OrderedExchange::turn() const
  {
    return mixed_bits(my_rank) /
           static_cast<double>(std::numeric_limits<std::uint64_t>::max());
  }



  void
  OrderedExchange::reinit(const NodeSpace &space)
  {
    finish_sending();
    outgoing.clear();
    incoming.clear();
    communicator    = space.communicator();
    my_rank         = Utilities::MPI::this_mpi_process(communicator);
    const auto side = [&](const unsigned int rank) {
      return is_earlier(rank) ? Neighbours::earlier : Neighbours::later;
    };
    for (const auto &[rank, nodes] : space.seen_elsewhere())
      {
        Outgoing message;
        message.rank = rank;
        message.side = side(rank);
        for (const auto global_node : nodes)
          {
            const unsigned int node = space.local(global_node);
            for (auto i = space.begin(node); i < space.begin(node + 1); ++i)
              message.unknowns.push_back(i);
          }
        message.buffer.resize(message.unknowns.size());
        outgoing.push_back(std::move(message));
      }
    for (unsigned int node = space.n_owned(); node < space.n_local(); ++node)
      {
        const unsigned int rank = space.rank_of(space.global(node));
        if (incoming.empty() || incoming.back().rank != rank)
          incoming.push_back({rank, side(rank), space.begin(node), 0});
        incoming.back().end = space.begin(node + 1);
      }
  }



  void
  OrderedExchange::send(const std::vector<double> &x, const Neighbours to) const
  {
    for (Outgoing &message : outgoing)
      {
        if (message.side != to)
          continue;
        int error = MPI_Wait(&message.request, MPI_STATUS_IGNORE);
        AssertThrowMPI(error);
        for (unsigned int i = 0; i < message.unknowns.size(); ++i)
          message.buffer[i] = x[message.unknowns[i]];
        error = MPI_Isend(message.buffer.data(),
                          message.buffer.size(),
                          MPI_DOUBLE,
                          message.rank,
                          message_tag,
                          communicator,
                          &message.request);
        AssertThrowMPI(error);
      }
  }



  void
  OrderedExchange::progress() const
  {
    for (Outgoing &message : outgoing)
      {
        int       is_sent;
        const int error =
          MPI_Test(&message.request, &is_sent, MPI_STATUS_IGNORE);
        AssertThrowMPI(error);
      }
  }



  void
  OrderedExchange::receive(std::vector<double> &x, const Neighbours from) const
  {
    for (const Incoming &message : incoming)
      {
        if (message.side != from)
          continue;
        const int error = MPI_Recv(x.data() + message.begin,
                                   message.end - message.begin,
                                   MPI_DOUBLE,
                                   message.rank,
                                   message_tag,
                                   communicator,
                                   MPI_STATUS_IGNORE);
        AssertThrowMPI(error);
      }
  }
} // namespace stickslip
