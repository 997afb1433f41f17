#ifndef stickslip_solid_rigid_coupling_h
#define stickslip_solid_rigid_coupling_h

#include <stickslip/base/types.h>

#include <stickslip/solid/coupling_masters.h>
#include <stickslip/solid/displacement_constraints.h>
#include <stickslip/solid/prescribed_displacement.h>
#include <stickslip/solid/rigid_motion.h>
#include <stickslip/solid/rigid_state.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace stickslip
{
  /**
   * Nodes that follow a reference point: those of a rigid body, or of a
   * boundary, whose rigid motion has free components q. There are no unknowns
   * for q: as many displacements of the nodes, the masters, stand for them,
   * and constraints make all others depend on these. Where the point is follows
   * from the displacements of all nodes, so a state needs nothing beside them.
   *
   * All functions are collective unless they say otherwise. Displacements u are
   * vectors of locally owned entries.
   */
  template <int dim>
  class RigidCoupling
  {
  public:
    /// @p nodes are those of locally owned dofs that follow the point of
    /// @p condition (which is copied). Degrees of freedom that @p geometric
    /// constrains are no masters. Throws UserError if the nodes do not
    /// determine a free rotation.
    RigidCoupling(const PrescribedDisplacement<dim> &condition,
                  const std::vector<HeldNode<dim>>  &nodes,
                  const Constraints                 &geometric,
                  const MPI_Comm                     communicator);

    const PrescribedDisplacement<dim> &
    condition() const
    {
      return prescribed;
    }

    /// Not collective.
    bool
    is_active(const double time) const
    {
      return prescribed.active.contains(time);
    }

    /// Turns the linearization to where the nodes are, with the prescribed
    /// components of @p time. With @p may_change_masters, or if there are none
    /// yet, the masters are others if those of before determine q badly;
    /// returns true (on all ranks) if they are.
    bool
    update(const double      time,
           const LA::Vector &u,
           const bool        may_change_masters);

    /// The same on all ranks. Not collective.
    const std::vector<types::global_dof_index> &
    masters() const
    {
      return master_dofs;
    }

    /// Lines of the increment of @p u, as of the last update(), for locally
    /// owned dofs.
    std::vector<ConstraintLine>
    lines(const LA::Vector &u) const;

    /// Adds force and torque, and springs if @p with_springs, in the state of the
    /// last update() to the owned rows of the masters. Not collective.
    void
    add_driving_forces(const double time,
                       const bool   with_springs,
                       LA::Vector  &forces) const;

    /// Adds to the rows and columns of the masters how their forces change with
    /// the motion where the nodal forces stay (@p unbalanced: internal and
    /// contact minus external ones): because arms and axes turn, and by
    /// springs.
    void
    add_tangent(const double      time,
                const LA::Vector &unbalanced,
                LA::SparseMatrix &matrix) const;

    /// Puts all nodes to where a rigid body has them that is closest to @p u.
    /// Nothing unless a rotation is free.
    void
    make_rigid(LA::Vector &u) const;

    /// The same with the prescribed components of @p time.
    void
    place(const double time, LA::Vector &u) const;

    RigidReaction<dim>
    reaction(const double      time,
             const LA::Vector &u,
             const LA::Vector &unbalanced) const;

  private:
    const PrescribedDisplacement<dim> prescribed;
    const MPI_Comm                    communicator;
    std::vector<unsigned int>         free_components;
    std::vector<RigidNode<dim>>       nodes; ///< locally owned
    ClosestRigidState<dim>            closest;
    std::vector<MasterCandidate<dim>> candidates; ///< of all ranks

    // of the last update()
    RigidState<dim>                      target; ///< of the nodes
    std::vector<types::global_dof_index> master_dofs;
    std::vector<unsigned int> master_rows; ///< dim candidate + direction
    FullMatrix<double>        inverse_map; ///< free components over masters

    RigidState<dim>
    state_of(const double time, const LA::Vector &u) const;

    /// The displacement of a node for a unit of a free component. Not
    /// collective.
    Tensor<1, dim>
    motion_of_arm(const unsigned int    component,
                  const Tensor<1, dim> &arm) const;

    /// By candidate and component (rows), scaled for the choice of masters.
    FullMatrix<double>
    map_of_candidates(const double length) const;

    /// Of the free components, from those of the masters' displacements.
    Vector<double>
    missing_at_masters(const LA::Vector &u) const;

    void
    place_at(const RigidState<dim> &state, LA::Vector &u) const;
  };
} // namespace stickslip

#endif
