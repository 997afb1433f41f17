#ifndef stickslip_contact_assembly_contact_assembler_h
#define stickslip_contact_assembly_contact_assembler_h

#include <stickslip/contact/assembly/contact_row_sizes.h>
#include <stickslip/contact/assembly/linearized_friction.h>
#include <stickslip/contact/assembly/point_evaluator.h>

#include <memory>
#include <vector>

namespace stickslip
{
  /**
   * Turns contact points into matrix and vector entries for one configuration
   * at a time: configure(), then as many evaluations as needed. Unknowns are
   * numbered [displacements, multipliers].
   */
  template <int dim>
  class ContactAssembler : public PointEvaluator<dim>
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

    /**
     * Sets the configuration: ghosted displacements now and at step start and
     * ghosted multipliers. Pairs all points: anew if the geometry is live, else
     * as they are frozen. The pairings, like all that is evaluated from then
     * on, depend on the arguments and on what the points remember, not on what
     * was configured before.
     */
    void
    configure(const LA::Vector &u,
              const LA::Vector &u_old,
              const LA::Vector &lambda);

    /// The present configuration is an accepted iterate: points remember its
    /// pairings (PairingHysteresis), and those that are new are found again
    /// with this memory. Nothing to do if the geometry is frozen.
    void
    accept_iterate();

    /// Adds, condensed with @p geometric, the contact forces to block 0 and the
    /// contact rows to block 1 of @p residual, and their sizes to @p sizes.
    void
    add_residual(const Constraints &geometric,
                 LA::BlockVector   &residual,
                 ContactRowSizes   &sizes);

    /// Adds the derivative of the residual and subtracts the residual from
    /// @p rhs. With @p linearize_geometry = false the geometric terms are left
    /// out even if the geometry is live (quasi-Newton).
    void
    add_tangent(const Constraints     &constraints,
                const bool             linearize_geometry,
                LA::BlockSparseMatrix &matrix,
                LA::BlockVector       &rhs);

    /// Adds the step's slip to the points' history and keeps the pairing.
    void
    accept_step();

    /// Forgets the pairing of a failed step, so that the next try starts from
    /// the accepted one.
    void
    restore();

    /// Chooses anew, in the present configuration, which faces of surfaces that
    /// meet themselves are slave. True if something has changed: configure()
    /// then has to be called again. Collective.
    bool
    choose_sides();

    /// Tells all ranks the sides that were read. Collective.
    void
    share_sides();

    /// Friction as the last add_tangent() has linearized it.
    const LinearizedFriction<dim> &
    linearized_friction() const
    {
      return friction;
    }

    const MPI_Comm &
    get_communicator() const
    {
      return communicator;
    }

  private:
    /// See linearized_friction().
    bool
    has_linearized_friction(const ContactPair<dim>  &pair,
                            const ContactPoint<dim> &point) const;

    /// Weak form of a point, and its tangent, in the order of point_dofs().
    void
    evaluate_local_residual(const ContactPair<dim>       &pair,
                            const ContactPoint<dim>      &point,
                            const ContactEvaluation<dim> &state,
                            Vector<double>               &local) const;

    void
    evaluate_local_tangent(const ContactPair<dim>       &pair,
                           const ContactPoint<dim>      &point,
                           const ContactEvaluation<dim> &state,
                           const bool                    linearize_geometry,
                           FullMatrix<double>           &local) const;

    std::vector<std::unique_ptr<ContactPair<dim>>> pairs;
    MultiplierNumbering                            numbering;
    LinearizedFriction<dim>                        friction;
    types::global_dof_index                        n_displacements;
    IndexSet                                       relevant_displacements;
    MPI_Comm                                       communicator;
  };



  /// Calls @p visit(pair, point) for all contact points of this rank, in the
  /// order of pairs and points.
  template <int dim, typename Visitor>
  void
  for_each_point(const ContactAssembler<dim> &contact, const Visitor &visit)
  {
    for (const auto &pair : contact.contact_pairs())
      for (auto &point : pair->points)
        visit(*pair, point);
  }
} // namespace stickslip

#endif
