#include <stickslip/linear_solvers/multigrid/fewer_ranks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    using Index = NodeSpace::Index;

    /// Ranks. More would send many messages to one, and make a level of parts
    /// of a few nodes each come together at once, which costs iterations.
    constexpr unsigned int largest_group = 8;



    /// Some of the nodes, in the order of their numbers.
    struct Part
    {
      std::vector<unsigned int> sizes, bodies;
      std::vector<Point<3>>     positions;
      std::vector<double>       reaches, modes;

      void
      append(const Part &other)
      {
        sizes.insert(sizes.end(), other.sizes.begin(), other.sizes.end());
        bodies.insert(bodies.end(), other.bodies.begin(), other.bodies.end());
        positions.insert(positions.end(),
                         other.positions.begin(),
                         other.positions.end());
        reaches.insert(reaches.end(),
                       other.reaches.begin(),
                       other.reaches.end());
        modes.insert(modes.end(), other.modes.begin(), other.modes.end());
      }

      /// For messages.
      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &sizes &bodies &positions &reaches &modes;
      }
    };



    /// The first rank with nodes of the group of this one, which has some. A
    /// group has those that begin in the same stretch of @p stretch nodes.
    unsigned int
    first_of_group(const NodeSpace &nodes, const Index stretch)
    {
      const std::vector<Index> &begins = nodes.first_nodes();
      const unsigned int        mine =
        Utilities::MPI::this_mpi_process(nodes.communicator());
      unsigned int first = mine;
      for (unsigned int rank = mine;
           rank-- > 0 && begins[rank] / stretch == begins[mine] / stretch;)
        if (begins[rank + 1] > begins[rank])
          first = rank;
      return first;
    }
  } // namespace



  void
  move_to_fewer_ranks(NodeSpace  &nodes,
                      Modes      &modes,
                      const Index least_unknowns)
  {
    const unsigned int n_owners = nodes.n_owners();
    const Index        n_groups =
      std::max<Index>((n_owners + largest_group - 1) / largest_group,
                      nodes.owned_unknowns().size() / least_unknowns);
    if (n_owners == 0 || 2 * n_groups > n_owners)
      return;

    Part part;
    for (unsigned int node = 0; node < nodes.n_owned(); ++node)
      part.sizes.push_back(nodes.size(node));
    part.bodies    = std::move(modes.nodes.bodies);
    part.positions = std::move(modes.nodes.positions);
    part.reaches   = std::move(modes.nodes.reaches);
    part.modes     = std::move(modes.values);

    const MPI_Comm communicator = nodes.communicator();
    const Index    stretch      = (nodes.n_global() + n_groups - 1) / n_groups;
    std::map<unsigned int, Part> sent;
    if (nodes.n_owned() > 0)
      {
        const unsigned int first = first_of_group(nodes, stretch);
        if (first != Utilities::MPI::this_mpi_process(communicator))
          sent[first] = std::exchange(part, {});
      }
    // ascending ranks have ascending nodes
    for (const auto &[rank, received] :
         Utilities::MPI::some_to_some(communicator, sent))
      part.append(received);
    nodes                 = NodeSpace(part.sizes, communicator);
    modes.nodes.bodies    = std::move(part.bodies);
    modes.nodes.positions = std::move(part.positions);
    modes.nodes.reaches   = std::move(part.reaches);
    modes.values          = std::move(part.modes);
  }
} // namespace stickslip
