#ifndef stickslip_contact_pairing_pair_faces_h
#define stickslip_contact_pairing_pair_faces_h

#include <stickslip/contact/surface/periodic_images.h>
#include <stickslip/contact/surface/surface_face.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <functional>
#include <set>
#include <vector>

namespace stickslip
{
  /// Collects the faces of the surfaces of a pair, with all that has to be
  /// measured where nothing is deformed.
  template <int dim>
  struct PairFaceCollector
  {
    const hp::MappingCollection<dim> &mapping;
    const DoFHandler<dim>            &dof_handler;
    const Constraints                &supports; ///< closed
    /// Longitudinal modulus of a cell by material id; infinity: rigid.
    const std::function<double(const types::material_id)> &modulus;
    const CrossSection                                    &cross_section;
    const PeriodicImages<dim>                             &images;
    bool has_curved_facets = false; ///< they stand for a smooth surface

    /**
     * The faces with the ids @p boundary of the body with the ids
     * @p boundary_of_body, ghosts and the images around periodic nodes
     * included, sorted; their shape is @p shape.
     * With thickness and rise, without nodal normals. Collective.
     */
    std::vector<CollectedFace<dim>>
    collect(const std::set<types::boundary_id> &boundary,
            const std::set<types::boundary_id> &boundary_of_body,
            const FaceShape<dim>               &shape,
            const MPI_Comm                     &communicator) const;
  };

  /**
   * Gives the @p slaves of a pair that only touches, neither they nor the
   * @p masters being partly concave, other rises. Averages of dual functions
   * over a gap like s^2/2R are negative, so that nodes would close h^2/12R too
   * early. A slave of degree 1 that is parallel to the master between its nodes
   * has gaps that are linear on each face, whose averages are the nodal values:
   * its rises are those of a master that is round in the same way everywhere (a
   * cylinder, a sphere), with the other sign. Elsewhere it keeps its facets.
   * @p slave_shape and @p master_shape are those of the faces. Collective.
   */
  template <int dim>
  void
  set_rises_of_convex_pairs(const FaceShape<dim>                  &master_shape,
                            const std::vector<CollectedFace<dim>> &masters,
                            const FaceShape<dim>                  &slave_shape,
                            const PeriodicImages<dim>             &images,
                            const MPI_Comm                        &communicator,
                            std::vector<CollectedFace<dim>>       &slaves);
} // namespace stickslip

#endif
