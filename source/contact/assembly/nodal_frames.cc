#include <stickslip/contact/assembly/nodal_frames.h>

#include <cmath>

namespace stickslip
{
  namespace
  {
    /// First axes of the multiplier nodes, not normalized, at their multipliers
    /// (ghosted).
    LA::Vector
    mean_axes(const ContactAssembler<3> &contact)
    {
      const auto &multipliers = contact.multipliers();
      LA::Vector  sum(multipliers.locally_owned(), contact.get_communicator());
      for_each_point(contact,
                     [&](const ContactPair<3>  &pair,
                         const ContactPoint<3> &point) {
                       if (!pair.parameters.has_tangential_traction() ||
                           !point.pairing.paired)
                         return;
                       const SlaveFace<3> &slave =
                         pair.slave_faces[point.geometry.slave_face];
                       const auto &dofs = slave.multiplier_dofs;
                       const auto &L =
                         pair.table.multiplier[point.geometry.quadrature_index];
                       for (unsigned int l = 0; l < L.size(); ++l)
                         {
                           // where the node itself is
                           const Tensor<1, 3> axis =
                             (point.geometry.reference_rotations[l][0][0] *
                                point.pairing.tau[0] +
                              point.geometry.reference_rotations[l][1][0] *
                                point.pairing.tau[1]) *
                             pair.rotation_at_multiplier(slave.face, l);
                           for (unsigned int c = 0; c < 3; ++c)
                             sum(dofs[l * 3 + c]) +=
                               point.geometry.weight * std::abs(L[l]) * axis[c];
                         }
                     });
      sum.compress(VectorOperation::add);
      LA::Vector ghosted(multipliers.locally_owned(),
                         multipliers.locally_relevant(),
                         contact.get_communicator());
      ghosted = sum;
      return ghosted;
    }
  } // namespace



  template <int dim>
  void
  update_nodal_frames(ContactAssembler<dim> &contact)
  {
    if constexpr (dim == 3)
      {
        const LA::Vector axes = mean_axes(contact);
        for_each_point(
          contact, [&axes](ContactPair<dim> &pair, ContactPoint<dim> &point) {
            if (!pair.parameters.has_tangential_traction() ||
                !point.pairing.paired)
              return;
            const SlaveFace<dim> &slave =
              pair.slave_faces[point.geometry.slave_face];
            const auto        &dofs = slave.multiplier_dofs;
            const auto        &tau  = point.pairing.tau;
            const Tensor<1, 3> n    = point.pairing.n;
            for (unsigned int l = 0; l < point.nodal_rotations.size(); ++l)
              {
                Tensor<1, 3> axis;
                for (unsigned int c = 0; c < 3; ++c)
                  axis[c] = axes(dofs[l * 3 + c]);
                axis = pair.rotation_at_multiplier(slave.face, l) * axis;
                Tensor<1, 3> t_1    = axis - (axis * n) * n;
                const double length = t_1.norm();
                // directions that cancel: the node is a sharp corner
                if (!(length > 1e-3 * axis.norm()))
                  continue;
                t_1 /= length;
                const Tensor<1, 3> t_2      = cross_product_3d(n, t_1);
                auto              &rotation = point.nodal_rotations[l];
                for (unsigned int a = 0; a < 2; ++a)
                  {
                    rotation[a][0] = tau[a] * t_1;
                    rotation[a][1] = tau[a] * t_2;
                  }
              }
          });
      }
    else
      (void)contact;
  }

  template void
  update_nodal_frames(ContactAssembler<2> &);
  template void
  update_nodal_frames(ContactAssembler<3> &);
} // namespace stickslip
