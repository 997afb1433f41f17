#ifndef stickslip_solid_support_forces_h
#define stickslip_solid_support_forces_h

#include <stickslip/mesh/periodic_nodes.h>

#include <stickslip/solid/boundary_conditions.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The forces that prescribed displacements exert on the bodies at time
   * @p time, by the name of the condition, in the order of
   * BoundaryConditions::prescribed_displacements(); in 2D per unit of
   * thickness, or, of bodies of revolution, all around (radial components are
   * summed up, whose vectors cancel). @p unbalanced (locally owned entries) is
   * what internal, contact and external forces leave at the nodes: at
   * equilibrium nothing but the forces of the supports.
   *
   * At a node that several conditions hold, each gets the part along the
   * directions that those before it leave free, so that the sum over all
   * conditions is the whole force. A node that follows a reference point counts
   * for that, whatever else holds it. Forces at images of nodes count for what
   * holds the node where it is itself, otherwise for what holds the image, as
   * they act there. Collective; the same on all ranks.
   */
  template <int dim>
  std::vector<std::pair<std::string, Tensor<1, dim>>>
  support_forces(const BoundaryConditions<dim>    &conditions,
                 const hp::MappingCollection<dim> &mapping,
                 const DoFHandler<dim>            &dof_handler,
                 const PeriodicNodes<dim>         &periodic_nodes,
                 const Bodies                     &bodies,
                 const double                      time,
                 const LA::Vector                 &unbalanced);
} // namespace stickslip

#endif
