#ifndef stickslip_contact_pairing_mortar_surface_h
#define stickslip_contact_pairing_mortar_surface_h

#include <stickslip/contact/pairing/corner_tangents.h>
#include <stickslip/contact/pairing/far_surfaces.h>
#include <stickslip/contact/pairing/mortar_derivatives.h>
#include <stickslip/contact/pairing/mortar_pairing.h>
#include <stickslip/contact/pairing/surface_sides.h>
#include <stickslip/contact/pairing/tool_pairing.h>
#include <stickslip/contact/point/contact_parameters.h>
#include <stickslip/contact/point/contact_points.h>
#include <stickslip/contact/surface/hanging_nodes.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace stickslip
{
  /**
   * The slave surface of a pair with `Quadrature = segments`: the multiplier
   * nodes of this rank, the slave faces around them, and the averages over the
   * segments in the present configuration.
   *
   * A node belongs to the rank that owns the first (by FaceId) of its slave
   * faces; the others are owned or ghosts, so no integral has to be sent.
   */
  template <int dim>
  class MortarSurface
  {
  public:
    using PairingPointer  = std::shared_ptr<const MortarPairing<dim>>;
    using Segments        = typename MortarPairing<dim>::Segments;
    using SegmentsPointer = std::shared_ptr<const Segments>;

    /**
     * @p slaves are all slave faces, ghosts included; @p points the contact
     * points of the nodal rule on @p owned_faces, of which one per node is
     * kept: it has the number of its node. @p hanging nodes have no point,
     * nor have @p excluded ones. Without sides (choose_sides()) a surface that
     * @p meets_itself has no partners. Not collective.
     */
    MortarSurface(const FaceShape<dim>                    &displacement_shape,
                  const FaceShape<dim>                    &master_shape,
                  const FaceShape<dim>                    &multiplier_shape,
                  const ContactPairParameters             &parameters,
                  const std::vector<CollectedFace<dim>>   &slaves,
                  const std::vector<SlaveFace<dim>>       &owned_faces,
                  const std::set<types::global_dof_index> &excluded,
                  const HangingNodes                      &hanging,
                  const CrossSection                      &cross_section,
                  const bool                               meets_itself,
                  std::vector<ContactPoint<dim>>          &points);

    const MortarNode<dim> &
    node(const unsigned int i) const
    {
      return nodes[i];
    }

    const FaceShape<dim> &
    slave_shape() const
    {
      return displacement_shape;
    }

    /// The slave faces around the nodes.
    const std::vector<MortarFace<dim>> &
    mortar_faces() const
    {
      return faces;
    }

    /// The present segments of mortar face @p f.
    const FaceSegments<dim> &
    segments(const unsigned int f) const
    {
      return (*current->segments)[f];
    }

    /// See symmetry_projection(). @p points are those of the nodes.
    void
    find_symmetry_planes(const Constraints              &supports,
                         std::vector<ContactPoint<dim>> &points);

    /// What is added to the gap: @p offset of a reference position.
    void
    update_gap_offsets(const std::function<double(const Point<dim> &)> &offset);

    /// What is added to the averaged gap of node @p i besides.
    void
    set_gap_offset(const unsigned int i, const double offset)
    {
      nodes[i].gap_offset = offset;
    }

    /// From now on the segments are the present ones, those of the undeformed
    /// bodies, and the nodes keep the relative position to their masters that
    /// they have: along the normal, @p tied also along the tangents. The
    /// master patch may not be fetched again.
    void
    keep_partners(const bool tied);

    bool
    keeps_partners() const
    {
      return kept != nullptr;
    }

    /// Takes @p share of what keep_partners() has seen as the relative
    /// position.
    void
    set_kept_share(const double share);

    /**
     * Chooses in the present configuration which faces of a surface that meets
     * itself are slave and master from now on. @p masters are the master faces
     * of this rank. True if something has changed. Collective.
     */
    bool
    choose_sides(const MasterPatch<dim>              &patch,
                 const std::vector<SurfaceFace<dim>> &masters,
                 const MPI_Comm                      &communicator);

    /// Takes the sides of the @p owned faces of all ranks. Collective.
    void
    resume_sides(const std::vector<SidedFace> &owned,
                 const MPI_Comm               &communicator);

    Side
    side_of(const FaceId &face) const
    {
      return sides.side_of(face);
    }

    /// Positions from ghosted displacements, now and at the start of the step.
    void
    update_configuration(const LA::Vector &u, const LA::Vector &u_old);

    /// Segments and frames in the present configuration: a function of the
    /// positions alone.
    PairingPointer
    find(const MasterPatch<dim> &patch) const;

    /// Takes @p pairing, found now or earlier, and averages over it in the
    /// present configuration.
    void
    use(const PairingPointer &pairing, const MasterPatch<dim> &patch);

    const MortarAverage<dim> &
    average(const unsigned int i) const
    {
      return averages[i];
    }

    const MortarFrame<dim> &
    frame(const unsigned int i) const
    {
      return current->frames[i];
    }

    /// See tangent_direction().
    Tensor<1, dim>
    direction(const unsigned int i) const
    {
      return tangent_direction(nodes[i], faces);
    }

    /// Current over reference area at node @p i of the faces around it, by
    /// their shares of what has a master opposite.
    double
    area_ratio(const unsigned int i) const;

    /// The frame of node @p i and the master face with the largest share of it.
    Pairing<dim>
    pairing_of(const unsigned int i) const;

    /// Master faces opposite node @p i, numbers in the patch, sorted.
    std::vector<unsigned int>
    masters_of(const unsigned int i) const
    {
      std::set<unsigned int> masters;
      for (const auto &around : nodes[i].faces)
        for (const unsigned int m : segments(around.face).masters)
          masters.insert(m);
      return {masters.begin(), masters.end()};
    }

    /// Derivative of the averages of node @p i; cheapest in the order of the
    /// nodes.
    void
    differentiate(const unsigned int      i,
                  const MasterPatch<dim> &patch,
                  MortarDerivative<dim>  &derivative);

    /// No more nodes are differentiated in this configuration: frees memory.
    void
    finish_derivatives()
    {
      shares.clear();
    }

    /// The pairing in use is an accepted iterate, or a frozen geometry.
    void
    accept_iterate()
    {
      remembered = current;
      far_nodes.accept_iterate();
    }

    /// Likewise, of an accepted step.
    void
    accept_step()
    {
      accepted = remembered = current;
      far_nodes.forget_touches();
    }

    /// Back to the accepted step.
    void
    restore()
    {
      remembered = accepted;
      far_nodes.forget_touches();
    }

    /// The last accepted iterate; empty before the first.
    const PairingPointer &
    last() const
    {
      return remembered;
    }

    /// The numbers of master faces have changed.
    void
    relocate(const MasterPatch<dim> &patch);

  private:
    const FaceShape<dim>            displacement_shape; ///< of the slave
    const FaceShape<dim>            multiplier_shape;
    const SegmentRule<dim>          rule;
    const ToolRule<dim>             tool_rule;
    const MortarIntegrals<dim>      integrals;
    const MortarDerivatives<dim>    derivatives;
    const CrossSection              cross_section;
    const bool                      meets_itself;
    const bool                      may_part; ///< unlike what is tied
    SurfaceSides                    sides; ///< of a surface that meets itself
    std::vector<MortarFace<dim>>    faces;
    std::vector<MortarNode<dim>>    nodes;
    std::vector<FaceIntegrals<dim>> over_faces; ///< of the present pairing
    std::vector<MortarAverage<dim>> averages;
    ShareDerivatives<dim>           shares;     ///< of those, now
    SegmentsPointer                 integrated; ///< what over_faces are of
    FarNodes<dim>                   far_nodes;  ///< likewise
    SegmentsPointer                 kept; ///< of a surface that cannot part
    std::vector<Tensor<1, dim>>     kept_positions; ///< r along n and tangents
    PairingPointer                  current;
    PairingPointer                  remembered;
    PairingPointer                  accepted;

    /// Returns the integrals of the functions over the faces: [face][l].
    std::vector<std::vector<double>>
    set_weightings();

    void
    take_sides();

    PairingPointer
    empty_pairing() const;

    SegmentsPointer
    find_all_segments(const MasterPatch<dim> &patch) const;
  };
} // namespace stickslip

#endif
