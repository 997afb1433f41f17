#ifndef stickslip_contact_assembly_contact_assembler_h
#define stickslip_contact_assembly_contact_assembler_h

#include <stickslip/contact/pairing/contact_pair.h>
#include <stickslip/contact/point/contact_element.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /// Which contact quantities are recomputed in every residual.
  struct Liveness
  {
    bool geometry  = true;
    bool threshold = true;
    bool status    = true;
  };

  /**
   * Turns contact points into matrix and vector entries for one configuration
   * at a time: configure(), then as many evaluations as needed. Unknowns are
   * numbered [displacements, multipliers].
   */
  template <int dim>
  class ContactAssembler
  {
  public:
    ContactAssembler(std::vector<std::unique_ptr<ContactPair<dim>>> pairs,
                     const IndexSet &owned_displacements,
                     const IndexSet &relevant_displacements,
                     const MPI_Comm &communicator);

    const MultiplierNumbering &
    multipliers() const
    {
      return numbering;
    }

    const std::vector<std::unique_ptr<ContactPair<dim>>> &
    contact_pairs() const
    {
      return pairs;
    }

    /// Displacement dofs that configure() reads.
    IndexSet
    needed_displacements() const;

    /// Fetches master patches where nodes moved too far (or with @p force);
    /// true if needed_displacements() changed. Frozen pairings become invalid
    /// then, so call it only before the geometry is evaluated. Collective.
    bool
    update_patches(const LA::Vector &u, const bool force);

    /// Sets the configuration: ghosted displacements now and at step start and
    /// ghosted multipliers. Pairs all points if the geometry is live.
    void
    configure(const LA::Vector &u,
              const LA::Vector &u_old,
              const LA::Vector &lambda);

    /// Adds, condensed with @p geometric, the contact forces to block 0 and the contact rows to block 1 of
    /// @p residual; @p row_scale collects the size that a contact row has for
    /// a gap of one face diameter, or |Lambda| off by one.
    void
    add_residual(const Constraints &geometric,
                 LA::BlockVector   &residual,
                 LA::Vector        &row_scale);

    /// Adds the derivative of the residual and subtracts the residual from
    /// @p rhs. With @p linearize_geometry = false the geometric terms are left
    /// out even if the geometry is live (quasi-Newton).
    void
    add_tangent(const Constraints     &constraints,
                const bool             linearize_geometry,
                LA::BlockSparseMatrix &matrix,
                LA::BlockVector       &rhs);

    /// State of a point in the present configuration, without derivatives.
    /// Valid until the next call.
    const ContactEvaluation<dim> &
    evaluate(const ContactPair<dim> &pair, const ContactPoint<dim> &point);

    /// S_c from the present multipliers and gap, frozen or not.
    bool
    live_closed(const ContactPair<dim> &pair, const ContactPoint<dim> &point);

    /// Coulomb threshold of a paired point from the present state, else 0.
    double
    live_threshold(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point);

    /// lambda_n at displacement node @p j of a slave face.
    double
    lambda_n_at_node(const ContactPair<dim> &pair,
                     const unsigned int      slave_face,
                     const unsigned int      j) const;

    /// Multipliers at a point from the ghosted @p values.
    Multipliers<dim>
    multipliers_at(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   const LA::Vector        &values) const;

    /// Global dofs of a point: slave nodes, master stencil, multipliers.
    std::vector<types::global_dof_index>
    point_dofs(const ContactPair<dim>  &pair,
               const ContactPoint<dim> &point) const;

    /// Adds the step's slip to the points' history and keeps the pairing.
    void
    accept_step();

    /// Forgets the pairing of a failed step, so that the next try starts from
    /// the accepted one.
    void
    restore();

    const MPI_Comm &
    get_communicator() const
    {
      return communicator;
    }

    Liveness live;

  private:
    std::vector<std::unique_ptr<ContactPair<dim>>> pairs;
    MultiplierNumbering                            numbering;
    types::global_dof_index                        n_displacements;
    IndexSet                                       relevant_displacements;
    MPI_Comm                                       communicator;
    LA::Vector                                     lambda;
    ContactEvaluation<dim>                         scratch;
    MasterPoint<dim>                               old_master;

    /// The point's data for contact_element.h. Points into the pair.
    ContactElement<dim>
    element_of(const ContactPair<dim>  &pair,
               const ContactPoint<dim> &point) const;

    void
    evaluate_kinematics(const ContactPair<dim>  &pair,
                        const ContactPoint<dim> &point,
                        const bool               linearize_geometry,
                        const bool               differentiate);

    ContactStatus
    present_status(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point) const;

    void
    evaluate_point(const ContactPair<dim>  &pair,
                   const ContactPoint<dim> &point,
                   const bool               linearize_geometry,
                   const bool               differentiate);

    Threshold
    threshold_kind(const ContactPair<dim> &pair) const;
  };
} // namespace stickslip

#endif
