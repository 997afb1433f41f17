#ifndef stickslip_problem_contact_problem_h
#define stickslip_problem_contact_problem_h

#include <stickslip/base/no_convergence.h>
#include <stickslip/base/parameter_file.h>
#include <stickslip/base/solve_counts.h>

#include <stickslip/contact/assembly/contact_assembler.h>
#include <stickslip/contact/assembly/contact_quantities.h>
#include <stickslip/contact/point/contact_parameters.h>

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/problem/body_support.h>
#include <stickslip/problem/contact_at_start.h>
#include <stickslip/problem/dof_layout.h>
#include <stickslip/problem/problem_constraints.h>
#include <stickslip/problem/problem_sparsity.h>
#include <stickslip/problem/residual_norms.h>
#include <stickslip/problem/system_description.h>

#include <stickslip/solid/boundary_conditions.h>
#include <stickslip/solid/material_parameters.h>
#include <stickslip/solid/rigid_body_check.h>
#include <stickslip/solid/solid_assembler.h>
#include <stickslip/solid/support_forces.h>

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The discrete problem of one load step: residual and tangent of solid and
   * contact for x = [displacements, multipliers], with the contact quantities
   * live or frozen. All functions are collective.
   */
  template <int dim>
  class ContactProblem
  {
  public:
    ContactProblem(
      Mesh<dim>                                    &mesh,
      const unsigned int                            degree,
      const NamedList<MaterialParameters>          &materials,
      const NamedList<BoundaryConditionParameters> &boundary_conditions,
      const NamedList<ContactPairParameters>       &contact_pairs,
      const bool                                    quasi_tangent,
      const Amplitudes                             &amplitudes = {});

    /// What is between the surfaces of each pair where nothing is deformed.
    const std::vector<ContactAtStart<dim>> &
    start() const
    {
      return contact_start;
    }

    /// A zero state (not ghosted).
    LA::BlockVector
    zero_state() const;

    /// Starts a step to @p time from the accepted state @p x_old.
    void
    begin_step(const double time, const LA::BlockVector &x_old);

    /// Another state is next, far from the last one: prescribed displacements
    /// that were applied may not be any more.
    void
    forget_state()
    {
      constraints->invalidate();
      is_configured = false;
    }

    /**
     * @p x is an accepted iterate of Newton's method, from which the next
     * increment starts. Renews what depends on accepted iterates: what contact
     * points remember of their pairings, contact scales, constraints of the
     * increment, nodal frames, restrained directions. Between two calls of this
     * function residual() and assemble() are functions of their argument.
     */
    void
    begin_iteration(const LA::BlockVector &x);

    /// Residual norms at @p x with the live quantities recomputed. A function of
    /// @p x, of what is frozen, and of the accepted iterates (begin_iteration()).
    ResidualNorms
    residual(const LA::BlockVector &x);

    /// Size up to which displacements (@p b = 0) or multipliers (1) are nothing
    /// but roundoff.
    double
    negligible_unknown(const unsigned int b) const;

    /// Largest prescribed displacement that @p x lacks, over ranks.
    double
    unapplied_displacement(const LA::BlockVector &x) const
    {
      return constraints->unapplied_displacement_of(time, x.block(0));
    }

    /// Load time of the step.
    double
    present_time() const
    {
      return time;
    }

    /// Constraints of displacements and multipliers as of the last residual:
    /// all, and those of hanging nodes and periodicity alone.
    const Constraints &
    increment_constraints() const
    {
      return constraints->increment();
    }

    const Constraints &
    geometric_constraints() const
    {
      return constraints->geometric();
    }

    const BoundaryConditions<dim> &
    conditions() const
    {
      return boundary_conditions;
    }

    /// Moves the rigid bodies to where their motion has them at the time of the
    /// step, in @p displacement (not ghosted).
    void
    place_rigid_bodies(LA::Vector &displacement) const
    {
      constraints->place_rigid_bodies(time, displacement);
    }

    /// See ProblemConstraints::make_rigid().
    void
    make_rigid(LA::Vector &displacement) const
    {
      constraints->make_rigid(time, displacement);
    }

    /// Puts hanging nodes to where their coarse side has them, in
    /// @p displacement (not ghosted).
    void
    make_conforming(LA::Vector &displacement) const
    {
      constraints->make_conforming(displacement);
    }

    /// Internal plus contact forces of the last residual: at equilibrium the
    /// loads and the reactions.
    const LA::Vector &
    nodal_forces() const
    {
      return forces;
    }

    /// Contact forces on the nodes of both bodies, with the sign of internal
    /// forces.
    const LA::Vector &
    contact_forces() const
    {
      return forces_of_contact;
    }

    /// The forces that supports exert in the last evaluated state
    /// (solid/support_forces.h). Collective.
    std::vector<std::pair<std::string, Tensor<1, dim>>>
    reactions() const
    {
      return support_forces(boundary_conditions,
                            dofs.mapping,
                            dofs.dof_handler,
                            dofs.periodic_nodes,
                            mesh.bodies,
                            time,
                            unbalanced);
    }

    /// What goes through the cuts of bolts, in the last evaluated state.
    /// Collective.
    std::vector<std::pair<std::string, CutReaction>>
    cut_reactions() const
    {
      return constraints->cut_reactions(configured_x.block(0), unbalanced);
    }

    /// Moments at the reference points of rigid motions with free components
    /// and of distributed forces, and where these are, in the last evaluated
    /// state. Collective.
    std::vector<std::pair<std::string, RigidReaction<dim>>>
    reference_points() const
    {
      auto points =
        constraints->reference_points(time, configured_x.block(0), unbalanced);
      for (const Load<dim> &load : boundary_conditions.loads())
        if (load.distribution)
          {
            points.emplace_back(
              load.name,
              load.distribution->mean_motion(dofs.mapping,
                                             dofs.dof_handler,
                                             load.boundary_ids,
                                             mesh.bodies.cross_section,
                                             u,
                                             time));
            if (!load.active.contains(time))
              points.back().second.moment = 0.;
          }
      return points;
    }

    /// Assembles matrix and right hand side of the increment at @p x.
    void
    assemble(const LA::BlockVector &x);

    const LA::BlockSparseMatrix &
    matrix() const
    {
      return system_matrix;
    }

    const LA::BlockVector &
    right_hand_side() const
    {
      return rhs;
    }

    /// What a linear solver may want to know about matrix().
    const BlockSystemDescription &
    describe_system();

    /// Sets the constrained entries of an increment.
    void
    distribute(LA::BlockVector &increment) const;

    /// The three quantities that outer loops may freeze: geometry, threshold,
    /// status.
    std::array<FreezableQuantity *, 3>
    quantities();

    /// False if a point of the last evaluated state is outside the range of its
    /// material.
    bool
    state_is_admissible() const
    {
      return solid_assembler->state_is_admissible();
    }

    /// Why and where it is.
    InadmissibleState
    inadmissible_state() const
    {
      return solid_assembler->inadmissible_state();
    }

    /// Keeps histories of the state @p x.
    void
    accept_step(const LA::BlockVector &x);

    /// Forgets the histories of a failed step.
    void
    restore();

    /// See body_support.h. Collective.
    std::vector<FreeMotion>
    free_motions() const
    {
      return free_rigid_motions(boundary_conditions,
                                mesh.bodies,
                                dofs.mapping,
                                dofs.dof_handler);
    }

    std::vector<FreeMotion>
    weakly_held_motions() const
    {
      return stickslip::weakly_held_motions(boundary_conditions,
                                            mesh.bodies,
                                            dofs,
                                            softest_spring);
    }

    /// By springs of any stiffness and nothing else but contact. Collective.
    std::vector<FreeMotion>
    motions_held_by_springs() const
    {
      return stickslip::weakly_held_motions(boundary_conditions,
                                            mesh.bodies,
                                            dofs,
                                            std::numeric_limits<double>::max());
    }

    void
    check_bodies_are_held()
    {
      stickslip::check_bodies_are_held(boundary_conditions,
                                       mesh.bodies,
                                       dofs,
                                       contact_assembler->contact_pairs());
    }

    const DofLayout<dim> &
    layout() const
    {
      return dofs;
    }

    const Bodies &
    bodies() const
    {
      return mesh.bodies;
    }

    ContactAssembler<dim> &
    contact()
    {
      return *contact_assembler;
    }

    SolidAssembler<dim> &
    solid()
    {
      return *solid_assembler;
    }

    const LA::Vector &
    ghosted_displacement() const
    {
      return u;
    }

    /// Brings contact and ghosted vectors to the state @p x. Free of cost if
    /// they are there already, as in the calls of one Newton iteration.
    void
    configure(const LA::BlockVector &x, const bool may_fetch_patches);

    /// Counts and times since the last reset.
    SolveCounts counts;

  private:
    Mesh<dim>                               &mesh;
    MPI_Comm                                 communicator;
    DofLayout<dim>                           dofs;
    const bool                               quasi_tangent;
    BoundaryConditions<dim>                  boundary_conditions;
    std::unique_ptr<SolidAssembler<dim>>     solid_assembler;
    std::unique_ptr<ContactAssembler<dim>>   contact_assembler;
    std::vector<ContactAtStart<dim>>         contact_start;
    std::unique_ptr<ProblemConstraints<dim>> constraints;
    std::unique_ptr<ProblemSparsity<dim>>    sparsity;
    std::unique_ptr<SystemDescription<dim>>  system_description;

    std::unique_ptr<ContactGeometry<dim>>        geometry;
    std::unique_ptr<FrictionThresholdField<dim>> threshold;
    std::unique_ptr<ContactStatusField<dim>>     status;

    double          time = 0.;
    LA::BlockVector x_old;
    LA::Vector      u, u_old, lambda; ///< ghosted
    LA::Vector      forces;           ///< internal plus contact
    LA::Vector      forces_of_contact;
    /// Forces minus loads, except those that drive reference points.
    LA::Vector unbalanced;
    double     extent         = 0.; ///< of the model
    double     force_floor    = 0.;
    double     softest_spring = 0.; ///< whose effect is above roundoff

    // what the last configure() was for
    bool            is_configured = false;
    LA::BlockVector configured_x;
    bool            configured_live      = false; ///< the geometry was live
    bool            patches_were_checked = false;

    LA::BlockSparseMatrix system_matrix;
    LA::BlockVector       rhs;

    /// What prescribes displacements where nothing is deformed, all the time.
    Constraints
    lasting_supports() const;

    void
    update_ghost_layout();

    /// True (on all ranks) if configure() has nothing to do: same state, step
    /// and liveness as the last time.
    bool
    is_configured_for(const LA::BlockVector &x,
                      const bool             may_fetch_patches) const;
  };
} // namespace stickslip

#endif
