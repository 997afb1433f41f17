#include <stickslip/contact/assembly/restrained_directions.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Free unknowns that move a point by less than this do not move it.
    constexpr double no_mobility = 1e-5;

    /// The same of a mortar node. Its foot on the master leaves a symmetry
    /// plane by the gap times the slope of a facet, as the facets of the two
    /// halves are not mirror images of each other.
    constexpr double no_mobility_of_node = 1e-2;

    /// r_t times a prescribed motion below this is none (far below the contact
    /// tolerance, far above roundoff).
    constexpr double no_motion = 1e-10;

    /// A direction is tangential if this much of its square is.
    constexpr double tangential_part = 0.01;



    /// How free unknowns move the point: relative motion = sum of value times
    /// increment, plus what constraints prescribe.
    template <int dim>
    struct RelativeMotion
    {
      std::map<types::global_dof_index, Tensor<1, dim>> free;
      Tensor<1, dim>                                    prescribed;
      Tensor<1, dim>                                    so_far; ///< in the step
    };



    /// Of a hanging node at least one over this acts on one free node.
    constexpr double parents_of_hanging_node = 4.;



    template <int dim>
    double
    negligible_mobility(const ContactPair<dim> &pair)
    {
      return pair.mortar ? no_mobility_of_node : no_mobility;
    }



    /// As if the point were where only the other nodes count: values below
    /// @p negligible are set to zero, the sum of the values stays one.
    void
    leave_out_negligible(const double negligible, std::vector<double> &shape)
    {
      double sum = 0.;
      for (double &value : shape)
        {
          if (std::abs(value) < negligible)
            value = 0.;
          sum += value;
        }
      for (double &value : shape)
        value /= sum;
    }



    /// Of the point itself, not of the average around a mortar node: on a
    /// symmetry plane it is the point that has no motion across the plane,
    /// while the average lacks the other half.
    template <int dim>
    RelativeMotion<dim>
    relative_motion(const ContactPair<dim>  &pair,
                    const ContactPoint<dim> &point,
                    const Constraints       &constraints)
    {
      RelativeMotion<dim> motion;
      const auto          add = [&](const StencilNodes<dim>   &nodes,
                           const std::vector<double> &shape,
                           const double               sign) {
        for (unsigned int j = 0; j < shape.size(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const auto dof = nodes.dofs[j * dim + c];
              // what the displacement moves there
              const Tensor<1, dim> value =
                sign * shape[j] *
                (nodes.rotation(j) * Point<dim>::unit_vector(c));
              if (!constraints.is_constrained(dof))
                motion.free[dof] += value;
              else
                {
                  for (const auto &[other, weight] :
                       *constraints.get_constraint_entries(dof))
                    motion.free[other] += weight * value;
                  motion.prescribed +=
                    constraints.get_inhomogeneity(dof) * value;
                }
            }
      };
      add(pair.slave_faces[point.geometry.slave_face].face,
          pair.table.displacement[point.geometry.quadrature_index].value,
          1.);
      const SlavePosition<dim> slave = pair.slave_position(point);
      motion.so_far                  = slave.x - slave.x_old;
      const Pairing<dim> pairing =
        pair.mortar ? pair.find_pairing(point) : point.pairing;
      std::vector<double> master_shape;
      if (pairing.paired)
        {
          pair.patch->evaluate_values(pairing.chart, pairing.xi, master_shape);
          leave_out_negligible(parents_of_hanging_node *
                                 negligible_mobility(pair),
                               master_shape);
          add(pair.patch->face(pairing.face), master_shape, -1.);
          const auto &now = pair.patch->configuration(pairing.face).positions;
          const auto &old =
            pair.patch->old_configuration(pairing.face).positions;
          for (unsigned int j = 0; j < master_shape.size(); ++j)
            motion.so_far -= master_shape[j] * (now[j] - old[j]);
        }
      return motion;
    }



    /// Orthonormal eigenvectors of @p K whose eigenvalue is at most @p bound.
    template <int dim>
    std::vector<Tensor<1, dim>>
    null_directions(const SymmetricTensor<2, dim> &K, const double bound)
    {
      std::vector<Tensor<1, dim>> directions;
      for (const auto &[value, vector] :
           eigenvectors(K, SymmetricTensorEigenvectorMethod::jacobi))
        if (value <= bound)
          directions.push_back(vector);
      return directions;
    }



    /// True if no constraint touches the slave nodes of the point: every
    /// direction is as free as the next, and nothing has to be evaluated.
    template <int dim>
    bool
    moves_freely(const ContactPair<dim>  &pair,
                 const ContactPoint<dim> &point,
                 const Constraints       &constraints)
    {
      const auto &dofs =
        pair.mortar ? pair.mortar->node(point.geometry.mortar_node).dofs
                    : pair.slave_faces[point.geometry.slave_face].face.dofs;
      return std::none_of(dofs.begin(), dofs.end(), [&](const auto dof) {
        return constraints.is_constrained(dof);
      });
    }



    /// Squares of the motion that free unknowns, or the step, give the point.
    template <int dim>
    SymmetricTensor<2, dim>
    mobility(const ContactPair<dim>  &pair,
             const ContactPoint<dim> &point,
             const Constraints       &constraints)
    {
      const auto motion = relative_motion(pair, point, constraints);
      SymmetricTensor<2, dim> K;
      for (const auto &[dof, value] : motion.free)
        K += symmetrize(outer_product(value, value));
      const Tensor<1, dim> w          = motion.so_far + motion.prescribed;
      const double         negligible = negligible_mobility(pair);
      Tensor<1, dim>       driven;
      for (const auto &h : null_directions(K, negligible * negligible))
        driven += (h * w) * h;
      if (point.regularization.r_t_law * driven.norm() > no_motion)
        {
          driven /= driven.norm();
          K += symmetrize(outer_product(driven, driven));
        }
      return K;
    }



    /// The tangential ones among the restrained directions.
    template <int dim>
    std::vector<Tensor<1, dim>>
    tangential_directions(const std::vector<Tensor<1, dim>> &restrained,
                          const Tensor<1, dim>              &n)
    {
      SymmetricTensor<2, dim> sum;
      for (const auto &h : restrained)
        {
          const Tensor<1, dim> t = h - (h * n) * n;
          sum += symmetrize(outer_product(t, t));
        }
      std::vector<Tensor<1, dim>> result;
      for (const auto &[value, vector] :
           eigenvectors(sum, SymmetricTensorEigenvectorMethod::jacobi))
        if (value > tangential_part)
          result.push_back(vector);
      return result;
    }



    /// Weighted mobilities of the multiplier nodes: row k of the tensor of a
    /// node is in vector k at the node's multipliers.
    template <int dim>
    using NodalTensors = std::array<LA::Vector, dim>;



    template <int dim>
    NodalTensors<dim>
    nodal_mobilities(ContactAssembler<dim> &contact,
                     const Constraints     &constraints)
    {
      const auto       &multipliers = contact.multipliers();
      NodalTensors<dim> sum, ghosted;
      for (unsigned int k = 0; k < dim; ++k)
        {
          sum[k].reinit(multipliers.locally_owned(),
                        contact.get_communicator());
          ghosted[k].reinit(multipliers.locally_owned(),
                            multipliers.locally_relevant(),
                            contact.get_communicator());
        }
      for_each_point(contact,
                     [&](const ContactPair<dim>  &pair,
                         const ContactPoint<dim> &point) {
                       if (!pair.parameters.has_tangential_traction() ||
                           !point.pairing.paired)
                         return;
                       const SymmetricTensor<2, dim> K =
                         moves_freely(pair, point, constraints)
                           ? unit_symmetric_tensor<dim>()
                           : mobility(pair, point, constraints);
                       const SlaveFace<dim> &slave =
                         pair.slave_faces[point.geometry.slave_face];
                       const auto &dofs = slave.multiplier_dofs;
                       const auto &L =
                         pair.table.multiplier[point.geometry.quadrature_index];
                       for (unsigned int l = 0; l < L.size(); ++l)
                         {
                           const Tensor<2, dim> R =
                             pair.rotation_at_multiplier(slave.face, l);
                           const Tensor<2, dim> at_node =
                             transpose(R) * Tensor<2, dim>(K) * R;
                           for (unsigned int k = 0; k < dim; ++k)
                             for (unsigned int c = 0; c < dim; ++c)
                               sum[k](dofs[l * dim + c]) +=
                                 std::abs(L[l]) * at_node[k][c];
                         }
                     });
      for (unsigned int k = 0; k < dim; ++k)
        {
          sum[k].compress(VectorOperation::add);
          ghosted[k] = sum[k];
        }
      return ghosted;
    }
  } // namespace



  template <int dim>
  void
  update_restrained_directions(ContactAssembler<dim> &contact,
                               const Constraints     &constraints,
                               const LA::Vector      &accepted_multipliers)
  {
    const auto nodal = nodal_mobilities(contact, constraints);
    for_each_point(
      contact, [&](ContactPair<dim> &pair, ContactPoint<dim> &point) {
        if (!pair.parameters.has_tangential_traction())
          return;
        point.restrained.directions.clear();
        if (!point.pairing.paired || moves_freely(pair, point, constraints))
          return;
        const SlaveFace<dim> &slave =
          pair.slave_faces[point.geometry.slave_face];
        const auto &dofs = slave.multiplier_dofs;
        const auto &L = pair.table.multiplier[point.geometry.quadrature_index];
        SymmetricTensor<2, dim> K;
        for (unsigned int l = 0; l < L.size(); ++l)
          if (std::abs(L[l]) > 1e-12)
            {
              const Tensor<2, dim> R =
                pair.rotation_at_multiplier(slave.face, l);
              Tensor<2, dim> at_node;
              for (unsigned int k = 0; k < dim; ++k)
                for (unsigned int c = 0; c < dim; ++c)
                  at_node[k][c] = nodal[k](dofs[l * dim + c]);
              K += symmetrize(R * at_node * transpose(R));
            }
        const double negligible = negligible_mobility(pair);
        point.restrained.directions =
          tangential_directions(null_directions(K, negligible * negligible),
                                point.pairing.n);
        if (point.restrained.directions.empty())
          return;
        point.restrained.Lambda =
          contact.multipliers_at(pair, point, accepted_multipliers).Lambda;
      });
  }

  template void
  update_restrained_directions(ContactAssembler<2> &,
                               const Constraints &,
                               const LA::Vector &);
  template void
  update_restrained_directions(ContactAssembler<3> &,
                               const Constraints &,
                               const LA::Vector &);
} // namespace stickslip
