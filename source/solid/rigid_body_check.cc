#include <stickslip/solid/rigid_body_check.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Mean position of the faces of one boundary. Collective.
    template <int dim>
    Point<dim>
    mean_face_position(const Triangulation<dim> &triangulation,
                       const types::boundary_id  id)
    {
      std::vector<double> sums(dim + 1, 0.);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == id)
              {
                sums[dim] += 1.;
                for (unsigned int d = 0; d < dim; ++d)
                  sums[d] += face->center()[d];
              }
      const std::vector<double> local = sums;
      Utilities::MPI::sum(local, triangulation.get_communicator(), sums);
      Point<dim> mean;
      for (unsigned int d = 0; d < dim; ++d)
        mean[d] = sums[d] / sums[dim];
      return mean;
    }



    /// A spring holds where its faces have their vertices.
    template <int dim>
    void
    hold_by_spring(const Load<dim>          &spring,
                   const Triangulation<dim> &triangulation,
                   RigidBodyModes<dim>      &modes)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() &&
                spring.boundary_ids.count(face->boundary_id()) > 0)
              for (const unsigned int v : face->vertex_indices())
                for (unsigned int d = 0; d < dim; ++d)
                  // Rows of d d^T, or of the identity: all along what is held.
                  if (spring.stiffness[d].norm() > 0.)
                    modes.hold(face->vertex(v),
                               spring.stiffness[d] /
                                 spring.stiffness[d].norm());
    }
  } // namespace



  template <int dim>
  std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<dim> &conditions,
                     const Bodies                  &bodies,
                     const Mapping<dim>            &mapping,
                     const DoFHandler<dim>         &dof_handler)
  {
    const Triangulation<dim> &triangulation = dof_handler.get_triangulation();
    const MPI_Comm            communicator  = dof_handler.get_communicator();

    std::vector<RigidBodyModes<dim>> modes;
    for (const auto &box : body_boxes(triangulation, bodies))
      modes.emplace_back(box.first, box.second);

    std::string error;
    for (const auto &node :
         find_held_nodes(mapping,
                         dof_handler,
                         bodies,
                         conditions.prescribed_displacements(),
                         0.,
                         error))
      for (const auto &row : node.second.rows)
        modes[node.second.body].hold(node.second.position, row.direction);
    throw_collectively(error, communicator);

    for (const Load<dim> &load : conditions.loads())
      if (load.type == BoundaryConditionType::spring)
        hold_by_spring(load, triangulation, modes[load.body]);

    for (const auto &pair : conditions.periodicities())
      {
        const Tensor<1, dim> offset =
          mean_face_position(triangulation, pair.second) -
          mean_face_position(triangulation, pair.first);
        modes[pair.body].tie(offset);
      }

    std::vector<FreeMotion> motions;
    for (unsigned int b = 0; b < bodies.bodies.size(); ++b)
      if (!bodies.bodies[b].is_rigid)
        {
          modes[b].sum_over_ranks(communicator);
          for (const std::string &motion : modes[b].unheld())
            motions.push_back({bodies.bodies[b].name, motion});
        }
    return motions;
  }



  template std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<2> &,
                     const Bodies &,
                     const Mapping<2> &,
                     const DoFHandler<2> &);
  template std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<3> &,
                     const Bodies &,
                     const Mapping<3> &,
                     const DoFHandler<3> &);
} // namespace stickslip
