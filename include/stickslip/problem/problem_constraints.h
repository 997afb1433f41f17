#ifndef stickslip_problem_problem_constraints_h
#define stickslip_problem_problem_constraints_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <stickslip/mesh/body.h>

#include <stickslip/problem/dof_layout.h>

#include <stickslip/solid/boundary_conditions.h>

#include <vector>

namespace stickslip
{
  /**
   * Constraints of the unknowns [displacements, multipliers]: geometric ones
   * (hanging nodes, periodicity) and all those of a Newton increment, which
   * also has to apply what is missing of the prescribed displacements.
   * Multipliers follow the displacements where these are interpolated and are
   * zero at excluded nodes.
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
    /// @p displacement (not ghosted). Collective.
    void
    place_rigid_bodies(const double time, LA::Vector &displacement) const;

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
    std::vector<bool>              master_is_rigid; ///< by pair
    IndexSet       rigid_dofs; ///< of rigid bodies, owned by this rank
    const MPI_Comm communicator;

    Constraints geometric_lines;
    Constraints increment_lines;
    double      unapplied     = 0.;
    bool        is_up_to_date = false;

    /// Hanging nodes and periodicity, as this rank sees them.
    Constraints
    geometric_lines_seen() const;

    double
    largest_inhomogeneity(const Constraints &lines,
                          const LA::Vector  &displacement) const;

    Constraints
    known_where_needed(const Constraints &seen) const;

    void
    constrain_multipliers(Constraints &lines) const;
  };
} // namespace stickslip

#endif
