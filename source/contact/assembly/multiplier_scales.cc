#include <stickslip/contact/assembly/multiplier_scales.h>

#include <stickslip/contact/assembly/contact_scales.h>

#include <cmath>
#include <vector>

namespace stickslip
{
  template <int dim>
  void
  add_multiplier_scales(ContactAssembler<dim> &contact,
                        const Constraints     &constraints,
                        LA::BlockVector       &regularization,
                        LA::BlockVector       &stiffness)
  {
    const types::global_dof_index n_displacements =
      regularization.block(0).size();
    Vector<double>                       flexible, stiff;
    std::vector<types::global_dof_index> dofs;
    for_each_point(
      contact,
      [&](const ContactPair<dim> &pair, const ContactPoint<dim> &point) {
        const auto &L = pair.table.multiplier[point.geometry.quadrature_index];
        const unsigned int n_comp = pair.n_multiplier_components();
        const double       k      = contact_stiffness(pair, point);
        // as large as rows of Lambda can be beside the size of r_t
        const double s = point.scales.threshold;

        dofs = pair.slave_faces[point.geometry.slave_face].multiplier_dofs;
        for (auto &dof : dofs)
          dof += n_displacements;
        flexible.reinit(dofs.size());
        stiff.reinit(dofs.size());
        for (unsigned int l = 0; l < L.size(); ++l)
          for (unsigned int c = 0; c < n_comp; ++c)
            {
              const double area        = point.geometry.weight * std::abs(L[l]);
              flexible(l * n_comp + c) = area / k * (c == 0 ? 1. : s * s);
              stiff(l * n_comp + c)    = area * k;
            }
        constraints.distribute_local_to_global(flexible, dofs, regularization);
        constraints.distribute_local_to_global(stiff, dofs, stiffness);
      });
  }

  template void
  add_multiplier_scales(ContactAssembler<2> &,
                        const Constraints &,
                        LA::BlockVector &,
                        LA::BlockVector &);
  template void
  add_multiplier_scales(ContactAssembler<3> &,
                        const Constraints &,
                        LA::BlockVector &,
                        LA::BlockVector &);
} // namespace stickslip
