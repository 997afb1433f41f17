#ifndef stickslip_solid_rigid_state_h
#define stickslip_solid_rigid_state_h

#include <stickslip/base/types.h>

#include <stickslip/solid/finite_rotation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Where a rigid body is: the displacement of its reference point and the
  /// rotation about that.
  template <int dim>
  struct RigidState
  {
    Tensor<1, dim> translation;
    FiniteRotation rotation;

    /// Of a point at @p arm from the reference point in the reference
    /// configuration: translation + (R - I) arm.
    Tensor<1, dim>
    displacement(const Tensor<1, dim> &arm) const;

    /// R arm; in 2D its third component is zero.
    Tensor<1, 3>
    current_arm(const Tensor<1, dim> &arm) const;
  };



  /// What drives or holds a rigid set of nodes, and where that has gone.
  template <int dim>
  struct RigidReaction
  {
    static constexpr unsigned int n_rotations = (dim == 2 ? 1 : 3);

    Tensor<1, n_rotations> moment; ///< about the displaced reference point
    Tensor<1, dim>         displacement; ///< of the reference point
    Tensor<1, n_rotations> rotation;     ///< vector, in degrees

    /// A number with its name: "moment_z", and the quantity that it belongs to:
    /// "moment".
    struct NamedValue
    {
      std::string quantity, name;
      double      value;
    };

    std::vector<NamedValue>
    named_values() const;
  };



  /// A node of a rigid body.
  template <int dim>
  struct RigidNode
  {
    std::array<types::global_dof_index, dim> dofs;
    Tensor<1, dim>                           arm; ///< reference configuration

    /// Of a vector with the owned entries. Not collective.
    Tensor<1, dim>
    values(const LA::Vector &vector) const;
  };



  /**
   * Finds where a rigid body is closest, in the mean square, to the
   * displacements of its nodes. Exact if they have moved as a rigid body.
   */
  template <int dim>
  class ClosestRigidState
  {
  public:
    /// No nodes.
    ClosestRigidState() = default;

    /// @p nodes are those that this rank owns. Collective.
    ClosestRigidState(const std::vector<RigidNode<dim>> &nodes,
                      const MPI_Comm                     communicator);

    /// False if the nodes are at a point or, in 3D, on a line.
    bool
    determines_rotation() const;

    /// Root mean square of the arms.
    double
    length() const;

    /// The state for the displacements @p u (owned entries), with the given
    /// rotation if that is not null. Collective.
    RigidState<dim>
    state_of(const LA::Vector                  &u,
             const std::vector<RigidNode<dim>> &nodes,
             const FiniteRotation              *rotation) const;

  private:
    MPI_Comm       communicator = MPI_COMM_NULL;
    unsigned int   n_nodes      = 0; ///< of all ranks
    Tensor<1, dim> mean_arm;
    Tensor<2, 3>   arm_moments; ///< about the mean
  };
} // namespace stickslip

#endif
