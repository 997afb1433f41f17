#ifndef stickslip_problem_problem_constraints_h
#define stickslip_problem_problem_constraints_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/mesh/body.h>

#include <stickslip/problem/dof_layout.h>
#include <stickslip/problem/multiplier_constraints.h>

#include <stickslip/solid/boundary_conditions.h>
#include <stickslip/solid/pretension_cut.h>
#include <stickslip/solid/rigid_coupling.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * Constraints of the unknowns [displacements, multipliers]: geometric ones
   * (hanging nodes, periodicity) and all those of a Newton increment, which
   * also has to apply what is missing of the prescribed displacements, and in
   * which nodes follow reference points or the other side of a cut.
   */
  template <int dim>
  class ProblemConstraints
  {
  public:
    /// The arguments must outlive this object, except @p bodies.
    ProblemConstraints(const DofLayout<dim>          &dofs,
                       const Bodies                  &bodies,
                       const BoundaryConditions<dim> &boundary_conditions,
                       const ContactAssembler<dim>   &contact,
                       const MPI_Comm                &communicator);

    /// Says that the time or the set of needed displacements changed.
    void
    invalidate()
    {
      is_up_to_date = false;
    }

    /// Renews the constraints for increments of @p displacement (not ghosted),
    /// unless a previous one that was accepted (an iterate of Newton's method,
    /// not a trial state of it) satisfied all of them already. Collective.
    void
    update(const double      time,
           const LA::Vector &displacement,
           const bool        is_accepted = false);

    /// Hanging nodes and periodicity.
    const Constraints &
    geometric() const
    {
      return geometric_lines;
    }

    /// All constraints of an increment.
    const Constraints &
    increment() const
    {
      return increment_lines;
    }

    /// Largest prescribed displacement that @p displacement (not ghosted) lacks,
    /// over ranks, whatever the last update was for. Collective.
    double
    unapplied_displacement_of(const double      time,
                              const LA::Vector &displacement) const;

    /// Moves the rigid bodies to where they are prescribed to be at @p time, in
    /// @p displacement (not ghosted), and makes what follows a reference point
    /// rigid. Collective.
    void
    place_rigid_bodies(const double time, LA::Vector &displacement) const;

    /// Puts the nodes that follow a reference point to where a rigid body has
    /// them that is closest: increments are linear, rotations are not.
    /// Collective.
    void
    make_rigid(const double time, LA::Vector &displacement) const;

    /// Puts hanging nodes (and periodic ones) to where what they hang on has
    /// them, in @p displacement (not ghosted). Collective.
    void
    make_conforming(LA::Vector &displacement) const;

    /// True once after an update that has changed where increment() leads: the
    /// sparsity is another one.
    bool
    has_new_masters()
    {
      return std::exchange(masters_are_new, false);
    }

    /// Forces that drive reference points, in the state of the last update(),
    /// and tensions of cuts, as forces on the nodes that stand for them;
    /// @p with_springs at the points.
    /// Collective.
    LA::Vector
    driving_forces(const double time, const bool with_springs) const;

    /// Adds these forces to the right hand side of an increment, and what
    /// RigidCoupling::add_tangent() says to the matrix, not compressed.
    /// @p unbalanced is what they leave. Collective.
    void
    add_driving_terms(const double           time,
                      const LA::Vector      &unbalanced,
                      LA::BlockSparseMatrix &matrix,
                      LA::BlockVector       &rhs) const;

    /// Moments and motions of the reference points, by condition. Collective.
    std::vector<std::pair<std::string, RigidReaction<dim>>>
    reference_points(const double      time,
                     const LA::Vector &displacement,
                     const LA::Vector &unbalanced) const;

    /// Tensions and shortenings of the cuts, by condition. Collective.
    std::vector<std::pair<std::string, CutReaction>>
    cut_reactions(const LA::Vector &displacement,
                  const LA::Vector &unbalanced) const;

    /// As of the last update().
    double
    unapplied_displacement() const
    {
      return unapplied;
    }

  private:
    const DofLayout<dim>          &dofs;
    const BoundaryConditions<dim> &boundary_conditions;
    const ContactAssembler<dim>   &contact;
    MultiplierConstraints<dim>     multiplier_constraints;
    IndexSet       rigid_dofs; ///< of rigid bodies, owned by this rank
    const MPI_Comm communicator;

    Constraints geometric_lines;
    Constraints increment_lines;
    double      unapplied       = 0.;
    bool        is_up_to_date   = false;
    bool        masters_are_new = false;

    std::vector<RigidCoupling<dim>> rigid_couplings;
    std::vector<PretensionCut<dim>> cuts;

    void
    find_couplings(const Bodies &bodies);

    /// With the masters of couplings and cuts, whose lines the ranks need.
    IndexSet
    with_masters(IndexSet dofs) const;

    /// Adds the lines of the increment of @p displacement, as far as this rank
    /// sees them, to geometric ones. Collective.
    void
    add_displacement_lines(const double                           time,
                           const LA::Vector                      &displacement,
                           const std::vector<RigidCoupling<dim>> &couplings,
                           Constraints                           &lines) const;

    /// Hanging nodes and periodicity, as this rank sees them.
    Constraints
    geometric_lines_seen() const;

    double
    largest_inhomogeneity(const Constraints &lines,
                          const LA::Vector  &displacement) const;

    Constraints
    known_where_needed(const Constraints &seen) const;
  };
} // namespace stickslip

#endif
