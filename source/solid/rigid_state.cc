#include <stickslip/solid/rigid_state.h>

#include <stickslip/base/in_space.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  namespace
  {
    template <int dim>
    Tensor<2, 3>
    outer_product_in_space(const Tensor<1, dim> &a, const Tensor<1, dim> &b)
    {
      return outer_product(in_space(a), in_space(b));
    }
  } // namespace



  template <int dim>
  Tensor<1, dim>
  RigidState<dim>::displacement(const Tensor<1, dim> &arm) const
  {
    const Tensor<1, 3> rotated = rotation.displacement(in_space(arm));
    Tensor<1, dim>     result  = translation;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] += rotated[d];
    return result;
  }



  template <int dim>
  Tensor<1, 3>
  RigidState<dim>::current_arm(const Tensor<1, dim> &arm) const
  {
    return rotation.rotate(in_space(arm));
  }



  template <int dim>
  std::vector<typename RigidReaction<dim>::NamedValue>
  RigidReaction<dim>::named_values() const
  {
    std::vector<NamedValue> values;
    const auto add = [&](const std::string &quantity, const auto &vector) {
      for (unsigned int i = 0; i < vector.dimension; ++i)
        values.push_back(
          {quantity,
           quantity + "_" + (vector.dimension == 1 ? 'z' : "xyz"[i]),
           vector[i]});
    };
    add("moment", moment);
    add("displacement", displacement);
    add("rotation", rotation);
    return values;
  }



  template <int dim>
  Tensor<1, dim>
  RigidNode<dim>::values(const LA::Vector &vector) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = vector(dofs[d]);
    return result;
  }



  template <int dim>
  ClosestRigidState<dim>::ClosestRigidState(
    const std::vector<RigidNode<dim>> &nodes,
    const MPI_Comm                     communicator)
    : communicator(communicator)
  {
    n_nodes = Utilities::MPI::sum(static_cast<unsigned int>(nodes.size()),
                                  communicator);
    for (const auto &node : nodes)
      mean_arm += node.arm;
    mean_arm =
      Utilities::MPI::sum(mean_arm, communicator) / std::max(n_nodes, 1u);
    for (const auto &node : nodes)
      arm_moments +=
        outer_product_in_space(node.arm - mean_arm, node.arm - mean_arm);
    arm_moments = Utilities::MPI::sum(arm_moments, communicator);
  }



  template <int dim>
  bool
  ClosestRigidState<dim>::determines_rotation() const
  {
    // the second invariant: products of two principal moments
    const double t = trace(arm_moments);
    return dim == 2 ? t > 0.
                    : t * t - trace(arm_moments * arm_moments) > 1e-12 * t * t;
  }



  template <int dim>
  double
  ClosestRigidState<dim>::length() const
  {
    return std::sqrt(mean_arm.norm_square() +
                     trace(arm_moments) / std::max(n_nodes, 1u));
  }



  template <int dim>
  RigidState<dim>
  ClosestRigidState<dim>::state_of(const LA::Vector                  &u,
                                   const std::vector<RigidNode<dim>> &nodes,
                                   const FiniteRotation *rotation) const
  {
    Tensor<1, dim> mean_u;
    Tensor<2, 3>   moments;
    for (const auto &node : nodes)
      {
        const Tensor<1, dim> u_node = node.values(u);
        mean_u += u_node;
        moments += outer_product_in_space(u_node, node.arm - mean_arm);
      }
    mean_u  = Utilities::MPI::sum(mean_u, communicator) / std::max(n_nodes, 1u);
    moments = Utilities::MPI::sum(moments, communicator);

    RigidState<dim> state;
    if (rotation != nullptr)
      state.rotation = *rotation;
    else if (dim == 2)
      state.rotation = FiniteRotation::about_z(
        std::atan2(moments[1][0] - moments[0][1],
                   trace(arm_moments) + trace(moments)));
    else
      state.rotation = FiniteRotation::closest(moments, arm_moments);
    state.translation = mean_u - state.displacement(mean_arm);
    return state;
  }



  template struct RigidState<2>;
  template struct RigidState<3>;
  template struct RigidReaction<2>;
  template struct RigidReaction<3>;
  template struct RigidNode<2>;
  template struct RigidNode<3>;
  template class ClosestRigidState<2>;
  template class ClosestRigidState<3>;
} // namespace stickslip
