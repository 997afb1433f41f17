#ifndef stickslip_contact_surface_excluded_nodes_h
#define stickslip_contact_surface_excluded_nodes_h

#include <stickslip/contact/surface/periodic_images.h>
#include <stickslip/contact/surface/surface_face.h>

#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Slave nodes without contact (first displacement dofs, of images those of
   * their originals), among the locally relevant ones: the nodes on
   * @p boundary, and those at the points "x,y; x,y" of @p points_text. Throws
   * UserError naming @p points_path (same on all ranks) if a point is none or
   * meets no slave node. Collective.
   */
  template <int dim>
  std::set<types::global_dof_index>
  excluded_slave_nodes(const std::vector<CollectedFace<dim>> &slave_faces,
                       const std::set<types::boundary_id>    &boundary,
                       const std::string                     &points_text,
                       const std::string                     &points_path,
                       const PeriodicImages<dim>             &images,
                       const hp::MappingCollection<dim>      &mapping,
                       const DoFHandler<dim>                 &dof_handler,
                       const MPI_Comm                        &communicator);
} // namespace stickslip

#endif
