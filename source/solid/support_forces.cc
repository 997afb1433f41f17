#include <stickslip/solid/support_forces.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/held_images.h>

#include <deal.II/base/mpi.h>

namespace stickslip
{
  template <int dim>
  std::vector<std::pair<std::string, Tensor<1, dim>>>
  support_forces(const BoundaryConditions<dim>    &conditions,
                 const hp::MappingCollection<dim> &mapping,
                 const DoFHandler<dim>            &dof_handler,
                 const PeriodicNodes<dim>         &periodic_nodes,
                 const Bodies                     &bodies,
                 const double                      time,
                 const LA::Vector                 &unbalanced)
  {
    const auto    &prescribed   = conditions.prescribed_displacements();
    const MPI_Comm communicator = dof_handler.get_communicator();
    std::string    error;
    auto           nodes =
      find_held_nodes(mapping, dof_handler, bodies, prescribed, time, error);
    add_rows_of_images(periodic_nodes,
                       dof_handler.locally_owned_dofs(),
                       prescribed,
                       time,
                       communicator,
                       nodes,
                       error);
    throw_collectively(error, communicator);

    std::vector<double> sums(dim * prescribed.size(), 0.);
    for (const auto &[first_dof, node] : nodes)
      {
        Tensor<1, dim> force;
        for (unsigned int d = 0; d < dim; ++d)
          force[d] = unbalanced(node.dofs[d]);
        if (node.is_coupled())
          {
            for (unsigned int d = 0; d < dim; ++d)
              sums[dim * node.coupling + d] += force[d];
            continue;
          }
        std::vector<Tensor<1, dim>> held; // orthonormal
        for (const auto &row : node.rows)
          {
            Tensor<1, dim> direction = row.direction;
            for (const auto &known : held)
              direction -= (row.direction * known) * known;
            if (direction.norm() < row.same_direction())
              continue;
            direction /= direction.norm();
            held.push_back(direction);
            const Tensor<1, dim> part =
              row.turned((force * direction) * direction);
            for (unsigned int d = 0; d < dim; ++d)
              sums[dim * row.condition + d] += part[d];
          }
      }
    const std::vector<double> of_this_rank = sums;
    Utilities::MPI::sum(of_this_rank, communicator, sums);

    std::vector<std::pair<std::string, Tensor<1, dim>>> result;
    for (unsigned int c = 0; c < prescribed.size(); ++c)
      {
        if (prescribed[c].is_of_axis)
          continue;
        Tensor<1, dim> force;
        for (unsigned int d = 0; d < dim; ++d)
          force[d] = sums[dim * c + d];
        result.emplace_back(prescribed[c].name, force);
      }
    return result;
  }

#define INSTANTIATE(dim)                                                       \
  template std::vector<std::pair<std::string, Tensor<1, dim>>> support_forces( \
    const BoundaryConditions<dim> &,                                           \
    const hp::MappingCollection<dim> &,                                        \
    const DoFHandler<dim> &,                                                   \
    const PeriodicNodes<dim> &,                                                \
    const Bodies &,                                                            \
    const double,                                                              \
    const LA::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
