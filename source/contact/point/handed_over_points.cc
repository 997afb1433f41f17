#include <stickslip/contact/point/handed_over_points.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>

namespace stickslip
{
  template <int dim>
  void
  hand_over_points(const HangingNodes                         &hanging,
                   const DoFHandler<dim>                      &dof_handler,
                   const std::vector<types::global_dof_index> &keys,
                   const unsigned int              n_multipliers_of_face,
                   const ContactPairParameters    &parameters,
                   const std::string              &path,
                   std::vector<ContactPoint<dim>> &points)
  {
    const MPI_Comm     communicator = dof_handler.get_communicator();
    const unsigned int any          = hanging.all().empty() ? 0 : 1;
    if (Utilities::MPI::max(any, communicator) == 0)
      return;
    if (!has_one_multiplier_per_point(parameters.quadrature))
      {
        if (dim == 3 && parameters.has_friction())
          throw UserError("'" + path + "/Quadrature = " +
                          name_of(parameters.quadrature, all_contact_rules()) +
                          "' is not available with friction on a slave surface "
                          "with cells of different levels. Take 'segments' or "
                          "'nodal'.");
        return;
      }
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    LinearAlgebra::distributed::Vector<double> own(
      dof_handler.locally_owned_dofs(), relevant, communicator);
    auto       with_share = own;
    const auto key_of     = [&](const ContactPoint<dim> &point) {
      return keys[point.geometry.slave_face * n_multipliers_of_face +
                  point.geometry.quadrature_index];
    };
    for (const auto &point : points)
      {
        const auto   key    = key_of(point);
        const double weight = point.geometry.weight;
        if (!hanging.contains(key))
          {
            own(key) += weight;
            with_share(key) += weight;
          }
        else
          for (const auto &[other, share] : *hanging.combination(key))
            with_share(other) += share * weight;
      }
    for (auto *vector : {&own, &with_share})
      {
        vector->compress(VectorOperation::add);
        vector->update_ghost_values();
      }
    points.erase(std::remove_if(points.begin(),
                                points.end(),
                                [&](const ContactPoint<dim> &point) {
                                  return hanging.contains(key_of(point));
                                }),
                 points.end());
    for (auto &point : points)
      point.geometry.weight *= with_share(key_of(point)) / own(key_of(point));
  }

  template void
  hand_over_points(const HangingNodes &,
                   const DoFHandler<2> &,
                   const std::vector<types::global_dof_index> &,
                   const unsigned int,
                   const ContactPairParameters &,
                   const std::string &,
                   std::vector<ContactPoint<2>> &);
  template void
  hand_over_points(const HangingNodes &,
                   const DoFHandler<3> &,
                   const std::vector<types::global_dof_index> &,
                   const unsigned int,
                   const ContactPairParameters &,
                   const std::string &,
                   std::vector<ContactPoint<3>> &);
} // namespace stickslip
