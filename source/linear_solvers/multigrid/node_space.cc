#include <stickslip/linear_solvers/multigrid/node_space.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.templates.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;



    /// First number of each rank, and at last the number of all.
    std::vector<Index>
    ranges(const Index n_owned, const MPI_Comm &communicator)
    {
      std::vector<Index> begins(1, 0);
      for (const Index n : Utilities::MPI::all_gather(communicator, n_owned))
        begins.push_back(begins.back() + n);
      return begins;
    }
  } // namespace



  NodeSpace::NodeSpace(const std::vector<unsigned int> &sizes,
                       const MPI_Comm                  &communicator)
    : comm(communicator)
    , n_owned_nodes(sizes.size())
    , rank_begins(ranges(sizes.size(), communicator))
    , begins(sizes.size() + 1, 0)
  {
    first = rank_begins[Utilities::MPI::this_mpi_process(comm)];
    std::partial_sum(sizes.begin(), sizes.end(), begins.begin() + 1);
    set_ghosts({});
  }



  NodeSpace::NodeSpace(const IndexSet    &unknowns,
                       const unsigned int n,
                       const MPI_Comm    &communicator)
    : NodeSpace(std::vector<unsigned int>(unknowns.n_elements() / n, n),
                communicator)
  {
    AssertThrow(unknowns.n_elements() % n == 0,
                ExcMessage("A node is on two ranks."));
  }



  unsigned int
  NodeSpace::rank_of(const Index node) const
  {
    return std::upper_bound(rank_begins.begin(), rank_begins.end(), node) -
           rank_begins.begin() - 1;
  }



  unsigned int
  NodeSpace::n_owners() const
  {
    unsigned int n = 0;
    for (unsigned int rank = 0; rank + 1 < rank_begins.size(); ++rank)
      n += rank_begins[rank + 1] > rank_begins[rank] ? 1 : 0;
    return n;
  }



  unsigned int
  NodeSpace::local(const Index node) const
  {
    if (owns(node))
      return node - first;
    const auto ghost = std::lower_bound(ghosts.begin(), ghosts.end(), node);
    Assert(ghost != ghosts.end() && *ghost == node, ExcInternalError());
    return n_owned_nodes + (ghost - ghosts.begin());
  }



  void
  NodeSpace::set_ghosts(std::vector<Index> nodes)
  {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    ghosts = std::move(nodes);
    begins.resize(n_owned_nodes + 1);

    const auto  unknowns = ranges(n_owned_unknowns(), comm);
    const Index mine     = unknowns[Utilities::MPI::this_mpi_process(comm)];
    IndexSet    owned(unknowns.back()), ghost_unknowns(unknowns.back());
    owned.add_range(mine, mine + n_owned_unknowns());

    std::map<unsigned int, std::vector<Index>> wanted;
    for (const Index node : ghosts)
      wanted[rank_of(node)].push_back(node);
    seen = Utilities::MPI::some_to_some(comm, wanted);
    // first unknown and size of each
    std::map<unsigned int, std::vector<std::pair<Index, unsigned int>>> answers;
    for (const auto &[rank, requested] : seen)
      for (const Index node : requested)
        answers[rank].emplace_back(mine + begins[node - first],
                                   size(node - first));
    // ranks, their ranges and so these answers are in ascending order
    for (const auto &[rank, ranges] :
         Utilities::MPI::some_to_some(comm, answers))
      for (const auto &[begin, size] : ranges)
        {
          ghost_unknowns.add_range(begin, begin + size);
          begins.push_back(begins.back() + size);
        }
    AssertDimension(begins.size(), n_local() + 1);
    partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(owned,
                                                          ghost_unknowns,
                                                          comm);
  }



  void
  NodeSpace::update_ghosts(std::vector<double> &vector) const
  {
    if (partitioner->n_mpi_processes() == 1)
      return;
    std::vector<MPI_Request> requests;
    std::vector<double>      sent(partitioner->n_import_indices());
    const unsigned int       n = n_owned_unknowns();
    AssertDimension(vector.size(), begins.back());
    const ArrayView<const double> owned(vector.data(), n);
    const ArrayView<double> received(vector.data() + n, vector.size() - n);
    const ArrayView<double> buffer(sent.data(), sent.size());
    partitioner->export_to_ghosted_array_start<double, MemorySpace::Host>(
      0, owned, buffer, received, requests);
    partitioner->export_to_ghosted_array_finish<double, MemorySpace::Host>(
      received, requests);
  }



  void
  NodeSpace::add_ghosts_to_owners(std::vector<double> &vector) const
  {
    if (partitioner->n_mpi_processes() == 1)
      return;
    std::vector<MPI_Request> requests;
    std::vector<double>      received(partitioner->n_import_indices());
    const unsigned int       n = n_owned_unknowns();
    AssertDimension(vector.size(), begins.back());
    const ArrayView<double> owned(vector.data(), n);
    const ArrayView<double> sent(vector.data() + n, vector.size() - n);
    const ArrayView<double> buffer(received.data(), received.size());
    partitioner->import_from_ghosted_array_start<double, MemorySpace::Host>(
      VectorOperation::add, 0, sent, buffer, requests);
    partitioner->import_from_ghosted_array_finish<double, MemorySpace::Host>(
      VectorOperation::add,
      ArrayView<const double>(received.data(), received.size()),
      owned,
      sent,
      requests);
  }
} // namespace stickslip
