#ifndef stickslip_contact_pairing_local_thickness_h
#define stickslip_contact_pairing_local_thickness_h

#include <stickslip/contact/surface/surface_face.h>

#include <deal.II/dofs/dof_handler.h>

#include <set>
#include <vector>

namespace stickslip
{
  /**
   * Sets SurfaceFace::thickness: the length [length] of the ray that starts in
   * the middle of a face, runs into its body along the normal and ends where it
   * leaves the body, through any of its faces, whoever owns them. Where nothing
   * is deformed; curved faces count as the flat ones between their vertices.
   * Infinity where the ray finds no way out. @p boundary_of_body are all
   * boundary ids of the body. Collective.
   */
  template <int dim>
  void
  measure_thickness(const DoFHandler<dim>              &dof_handler,
                    const std::set<types::boundary_id> &boundary_of_body,
                    const MPI_Comm                     &communicator,
                    std::vector<CollectedFace<dim>>    &faces);
} // namespace stickslip

#endif
