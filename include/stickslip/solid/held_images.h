#ifndef stickslip_solid_held_images_h
#define stickslip_solid_held_images_h

#include <stickslip/mesh/periodic_nodes.h>

#include <stickslip/solid/prescribed_displacement.h>

#include <deal.II/base/index_set.h>

#include <map>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * A node on periodic boundaries has several places, and conditions may name
   * any of them: what is prescribed at images becomes rows of their originals.
   * @p nodes are those that @p conditions hold at time @p time
   * (find_held_nodes), @p owned the locally owned degrees of freedom.
   *
   * A reference point has to hold a node at all of its places and to move it
   * alike at each; otherwise a text is added to @p error, on the ranks that see
   * it. Collective.
   */
  template <int dim>
  void
  add_rows_of_images(const PeriodicNodes<dim> &periodic_nodes,
                     const IndexSet           &owned,
                     const std::vector<PrescribedDisplacement<dim>> &conditions,
                     const double                                    time,
                     const MPI_Comm communicator,
                     std::map<types::global_dof_index, HeldNode<dim>> &nodes,
                     std::string                                      &error);
} // namespace stickslip

#endif
