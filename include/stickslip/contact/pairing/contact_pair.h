#ifndef stickslip_contact_pairing_contact_pair_h
#define stickslip_contact_pairing_contact_pair_h

#include <stickslip/contact/pairing/gap_offsets.h>
#include <stickslip/contact/pairing/master_patch.h>
#include <stickslip/contact/pairing/mortar_surface.h>
#include <stickslip/contact/pairing/moved_nodes.h>
#include <stickslip/contact/pairing/slave_configuration.h>
#include <stickslip/contact/point/contact_parameters.h>
#include <stickslip/contact/point/contact_points.h>
#include <stickslip/contact/surface/hanging_nodes.h>
#include <stickslip/contact/surface/multiplier_numbering.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /// The boundary ids of the triangulation that make a pair, and the cells
  /// behind them.
  struct PairSurfaces
  {
    std::set<types::boundary_id> slave;
    std::set<types::boundary_id> master;
    std::set<types::boundary_id> excluded;    ///< without contact
    std::set<types::boundary_id> slave_body;  ///< all of this body
    std::set<types::boundary_id> master_body; ///< likewise
    /// First dofs of further nodes without contact, among the relevant ones.
    std::set<types::global_dof_index> excluded_nodes = {};
    CrossSection                      cross_section  = {};
    /// Of which bodies these are the cells: faces have their own shape on each
    /// side.
    ReferenceCell slave_cells   = ReferenceCell();
    ReferenceCell master_cells  = ReferenceCell();
    unsigned int  slave_number  = 0; ///< of the body
    unsigned int  master_number = 0; ///< likewise

    /// True if the pair is a surface that meets itself.
    bool
    have_common_faces() const
    {
      return std::any_of(slave.begin(), slave.end(), [this](const auto id) {
        return master.count(id) > 0;
      });
    }
  };



  /// A rigid tool as a master.
  template <int dim>
  struct ToolMaster
  {
    std::shared_ptr<const RigidTool<dim>> tool; ///< nullptr: none
    /// The face that stands for it, on the rank that owns its cell.
    std::vector<SurfaceFace<dim>> owned_frame;
  };



  /// The pairings of all points of a pair in one configuration.
  template <int dim>
  struct FoundPairings
  {
    std::vector<Pairing<dim>>                   points; ///< not with segments
    typename MortarSurface<dim>::PairingPointer segments;
  };



  /**
   * A slave and a master surface: the slave faces and contact points of this
   * rank and the patch of master faces around them. Knows geometry and
   * parameters; the law and the assembly are elsewhere.
   */
  template <int dim>
  class ContactPair
  {
  public:
    /**
     * @p supports (closed) are what holds nodes for good, @p modulus is the
     * longitudinal modulus of a cell by material id (infinity: rigid), @p tool
     * the master if it is a rigid tool, @p images what periodic boundaries
     * repeat. Throws UserError (same on all ranks).
     * Collective.
     */
    ContactPair(const std::string                &name,
                const ContactPairParameters      &parameters,
                const PairSurfaces               &surfaces,
                const hp::MappingCollection<dim> &mapping,
                const DoFHandler<dim>            &dof_handler,
                const Constraints                &supports,
                const std::function<double(const types::material_id)> &modulus,
                const ToolMaster<dim>                                 &tool,
                const std::shared_ptr<const PeriodicImages<dim>>      &images,
                const MPI_Comm &communicator);

    /// 1 (without tangential traction) or dim.
    unsigned int
    n_multiplier_components() const
    {
      return parameters.has_tangential_traction() ? dim : 1;
    }

    /// Of the master's facets; a rigid tool needs none.
    bool
    has_smoothed_normals() const
    {
      return parameters.has_smoothed_normals() && patch->tool() == nullptr;
    }

    /// Multiplier nodes of the owned slave faces (first displacement dofs).
    std::vector<types::global_dof_index>
    multiplier_keys() const;

    /// What brings the master to the image of it that @p point meets, most of
    /// all; nothing if it meets the master itself or nothing.
    std::optional<PeriodicMotion>
    image_of_master(const ContactPoint<dim> &point) const
    {
      if (!point.pairing.paired)
        return {};
      return patch->motion_to(point.pairing.face);
    }

    /// Of multiplier node @p l of a slave face (StencilNodes::rotation()).
    Tensor<2, dim>
    rotation_at_multiplier(const SurfaceFace<dim> &face,
                           const unsigned int      l) const
    {
      return face.rotation(
        displacement_node(displacement_shape, multiplier_shape, l));
    }

    /// Nodes without contact, among the locally relevant ones.
    const std::set<types::global_dof_index> &
    excluded_keys() const
    {
      return excluded;
    }

    /// Displacements of nodes that this rank sees images of.
    const std::set<types::global_dof_index> &
    periodic_originals() const
    {
      return images->original_dofs();
    }

    /// Multiplier nodes that follow others.
    const HangingNodes &
    hanging_nodes() const
    {
      return hanging;
    }

    void
    set_multiplier_dofs(const MultiplierNumbering &numbering,
                        const unsigned int         pair_index);

    /// Fetches the master patch if a node moved by more than half its margin
    /// since the last time (always with @p force), unless the pair keeps its
    /// partners. True if that changed a rank's patch. Collective.
    bool
    update_patch(const LA::Vector &u, const bool force);

    /// Evaluates what is added to the gaps at @p time. Throws UserError (same
    /// on all ranks) if that is not a number somewhere. Collective.
    void
    update_gap_offsets(const double time)
    {
      gap_offsets.apply(time, communicator, points, mortar.get());
    }

    /// The present configuration is that of the undeformed bodies, with these
    /// @p depths (GapOffsets). A pair that cannot part keeps its partners.
    void
    set_start(const std::vector<double> &depths)
    {
      gap_offsets.set_depths_at_start(depths);
      if (parameters.is_bilateral())
        mortar->keep_partners(parameters.is_tied());
    }

    /// Positions of both sides from ghosted displacements, now and at the
    /// start of the step.
    void
    update_configuration(const LA::Vector &u, const LA::Vector &u_old);

    /// Pairing and local frame of a point in the present configuration. Starts
    /// from what the point remembers (PairingHysteresis), not from its present
    /// pairing.
    Pairing<dim>
    find_pairing(const ContactPoint<dim> &point) const;

    /// All pairings in the present configuration.
    FoundPairings<dim>
    find_pairings() const;

    /// Those of the last accepted iterate or frozen geometry, without those
    /// that are no longer in the patch.
    FoundPairings<dim>
    last_pairings() const;

    /// The points take these pairings.
    void
    use_pairings(const FoundPairings<dim> &pairings);

    /// The present pairings are those of an accepted iterate or a frozen
    /// geometry. Those that follow from that memory are found again with
    /// @p find_again.
    void
    accept_iterate(const bool find_again);

    /// Likewise, of an accepted step.
    void
    accept_step();

    /// Back to the pairings of the last accepted step.
    void
    restore();

    /// True if the pair is a surface that meets itself.
    bool
    meets_itself() const
    {
      return surfaces.have_common_faces();
    }

    /// Chooses in the present configuration which faces of a surface that
    /// meets itself are slave and which master. True if something has changed.
    /// Collective.
    bool
    choose_sides();

    /// Tells all ranks the sides that the owned slave faces of a surface that
    /// meets itself have. Collective.
    void
    share_sides();

    SlavePosition<dim>
    slave_position(const ContactPoint<dim> &point) const
    {
      return slave_configuration.position(table, point);
    }

    /// The slave area that the traction at a point acts on, undeformed.
    double
    area_of(const ContactPoint<dim> &point) const
    {
      return point.pairing.paired && mortar
               ? mortar->average(point.geometry.mortar_node).area
               : point.geometry.weight;
    }

    /// Current over reference area of the slave surface at a point.
    double
    area_ratio(const ContactPoint<dim> &point) const
    {
      return mortar ? mortar->area_ratio(point.geometry.mortar_node)
                    : slave_configuration.area_ratio(slave_faces,
                                                     table,
                                                     point,
                                                     surfaces.cross_section);
    }

    const ContactPairParameters         parameters;
    const std::string                   name;
    const PairSurfaces                  surfaces;
    const FaceShape<dim>                displacement_shape; ///< of the slave
    const FaceShape<dim>                multiplier_shape;
    SlaveShapeTable<dim>                table;
    std::vector<SlaveFace<dim>>         slave_faces;
    std::vector<ContactPoint<dim>>      points;
    std::unique_ptr<MasterPatch<dim>>   patch;
    std::unique_ptr<MortarSurface<dim>> mortar; ///< only with segments
    double largest_slave_diameter = 0.;         ///< over ranks
    /// Of both sides, over ranks; unit of the Lambda of a tied pair [stress].
    double softest_modulus = 0.;
    bool   has_to_hold     = false; ///< a body that nothing else holds

    /// Positions of the nodes of an owned slave face.
    const std::vector<Tensor<1, dim>> &
    slave_positions(const unsigned int slave_face) const
    {
      return slave_configuration.positions(slave_face);
    }

  private:
    /// Of its parameters.
    std::string
    path() const
    {
      return "Contact/" + name;
    }

    Pairing<dim>
    last_pairing(const ContactPoint<dim> &point) const;

    /// The faces around which master faces are needed.
    std::vector<const SurfaceFace<dim> *>
    searching_faces() const;

    std::shared_ptr<const PeriodicImages<dim>> images;
    GapOffsets<dim>                            gap_offsets;
    MPI_Comm                                   communicator;
    std::set<types::global_dof_index>          excluded;
    HangingNodes                               hanging;
    SlaveConfiguration<dim>                    slave_configuration;
    MovedNodes<dim> slave_nodes;  ///< since the patch was fetched
    MovedNodes<dim> master_nodes; ///< likewise
    double          margin = 0.;
  };
} // namespace stickslip

#endif
