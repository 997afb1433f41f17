#include <stickslip/contact/assembly/linearized_friction.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// A pressure that vanishes makes Lambda no longer than this factor: its
    /// direction is all that counts outside of the disc.
    constexpr double largest_ratio = 1e3;
  } // namespace



  template <int dim>
  void
  LinearizedFriction<dim>::reinit(const IndexSet &owned,
                                  const MPI_Comm &communicator)
  {
    forces.reinit(owned, communicator);
    areas.reinit(owned, communicator);
  }



  template <int dim>
  void
  LinearizedFriction<dim>::add_point(const types::global_dof_index first_dof,
                                     const double friction_coefficient,
                                     const ContactPoint<dim>      &point,
                                     const Tensor<2, dim - 1>     &rotation,
                                     const ContactEvaluation<dim> &state)
  {
    const double force = point.geometry.weight * state.response.threshold;
    if (force <= 0.)
      return;
    areas(first_dof) += point.geometry.weight * friction_coefficient;
    forces(first_dof) += force;
    for (unsigned int b = 0; b < dim - 1; ++b)
      for (unsigned int a = 0; a < dim - 1; ++a)
        forces(first_dof + 1 + b) +=
          force * rotation[a][b] *
          (state.kinematics.tau[a] * state.response.friction_direction);
  }



  template <int dim>
  void
  LinearizedFriction<dim>::compress()
  {
    forces.compress(VectorOperation::add);
    areas.compress(VectorOperation::add);
  }



  template <int dim>
  void
  LinearizedFriction<dim>::convert_increment(
    const std::vector<MultiplierNode> &nodes,
    const LA::Vector                  &multipliers,
    LA::Vector                        &increment) const
  {
    for (const MultiplierNode &node : nodes)
      {
        const auto i = node.first_dof;
        // pairs without friction have no Lambda, and no area
        const double before = forces(i);
        const double after  = -areas(i) * (multipliers(i) + increment(i));
        if (before <= 0. || after <= 0.)
          continue;
        const double ratio = std::min(before / after, largest_ratio);
        for (unsigned int c = 1; c < dim; ++c)
          {
            const double T      = forces(i + c) / before;
            const double Lambda = multipliers(i + c);
            const double linear = Lambda + increment(i + c);
            increment(i + c)    = T + ratio * (linear - T) - Lambda;
          }
      }
    increment.compress(VectorOperation::insert);
  }

  template class LinearizedFriction<2>;
  template class LinearizedFriction<3>;
} // namespace stickslip
