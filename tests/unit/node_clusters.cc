// Clusters of a smoother: nodes of a lattice of cubes are alone, those of a
// stretched one are together across its layers, within a rank and a body.

#include "lattice.h"
#include "print.h"

#include <stickslip/linear_solvers/multigrid/block_gauss_seidel.h>
#include <stickslip/linear_solvers/multigrid/read_blocks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  bool
  on_all_ranks(const bool value)
  {
    return Utilities::MPI::min(value ? 1 : 0, MPI_COMM_WORLD) == 1;
  }



  void
  test(const double stretch)
  {
    print("Stretched " + std::to_string(int(stretch)) + " times");
    constexpr unsigned int n = 8;
    const Lattice          lattice(n, 1., 1., MPI_COMM_WORLD, stretch);
    const NodeSpace        nodes(lattice.owned, 3, MPI_COMM_WORLD);
    const BlockMatrix  A(read_square_blocks(lattice.matrix, 3), nodes, nodes);
    const NodePlaces   places   = lattice.modes().nodes;
    const NodeClusters clusters = find_clusters(A, places);

    std::vector<unsigned int> n_times(A.n_rows(), 0);
    bool         are_alone = true, are_columns = true, are_in_one_body = true;
    unsigned int largest = 0;
    for (unsigned int cluster = 0; cluster < clusters.n(); ++cluster)
      {
        const auto         members = clusters.nodes(cluster);
        const unsigned int first   = members[0];
        const Point<3>    &place   = places.positions[first];
        are_alone                  = are_alone && members.size() == 1;
        largest = std::max<unsigned int>(largest, members.size());
        for (const unsigned int node : members)
          {
            ++n_times[node];
            are_columns = are_columns &&
                          place[0] == places.positions[node][0] &&
                          place[1] == places.positions[node][1];
            are_in_one_body = are_in_one_body &&
                              places.bodies[node] == places.bodies[first] &&
                              clusters.of_node[node] == cluster;
          }
      }
    print("each node is in one cluster",
          on_all_ranks(
            std::all_of(n_times.begin(),
                        n_times.end(),
                        [](const unsigned int k) { return k == 1; })));
    print("nodes are alone: " +
          std::string(on_all_ranks(are_alone) ? "yes" : "no"));
    print("clusters are across the layers", on_all_ranks(are_columns));
    print("each is in one body", on_all_ranks(are_in_one_body));
    print("they have at most 16 nodes", on_all_ranks(largest <= 16));
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test(1.);
  test(2.);
  test(4.);
  test(8.);
}
