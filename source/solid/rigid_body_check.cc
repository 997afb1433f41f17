#include <stickslip/solid/rigid_body_check.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <stickslip/solid/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    template <int dim>
    using Box = std::pair<Point<dim>, Point<dim>>;



    /// The boxes around all bodies of each group, from those of the bodies.
    template <int dim>
    std::vector<Box<dim>>
    boxes_of_groups(const std::vector<Box<dim>>     &of_bodies,
                    const std::vector<unsigned int> &group_of_body)
    {
      std::map<unsigned int, Box<dim>> boxes;
      for (unsigned int b = 0; b < of_bodies.size(); ++b)
        {
          Box<dim> &box =
            boxes.emplace(group_of_body[b], of_bodies[b]).first->second;
          for (unsigned int d = 0; d < dim; ++d)
            {
              box.first[d]  = std::min(box.first[d], of_bodies[b].first[d]);
              box.second[d] = std::max(box.second[d], of_bodies[b].second[d]);
            }
        }
      std::vector<Box<dim>> result;
      for (const auto &[group, box] : boxes)
        result.push_back(box);
      return result;
    }



    /// A spring that is stiff enough holds where its faces have their vertices.
    template <int dim>
    void
    hold_by_spring(const Load<dim>          &spring,
                   const Triangulation<dim> &triangulation,
                   const double              softest_spring,
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
                  if (spring.stiffness[d].norm() > softest_spring)
                    modes.hold(face->vertex(v),
                               spring.stiffness[d] /
                                 spring.stiffness[d].norm());
    }



    /// A reference point holds what it does not leave free, and what its
    /// springs hold. Its whole boundary is one rigid body.
    template <int dim>
    void
    hold_by_reference_point(const RigidMotion<dim> &motion,
                            RigidBodyModes<dim>    &modes)
    {
      for (unsigned int c = 0; c < motion.n_components; ++c)
        if (!motion.is_free(c) || motion.stiffness(c) > 0.)
          {
            if (c < dim)
              modes.hold(motion.reference_point(), Point<dim>::unit_vector(c));
            else
              modes.hold_rotation(motion.rotation_axis(c));
          }
    }



    /// What the conditions hold of the motions of each group.
    template <int dim>
    std::vector<RigidBodyModes<dim>>
    held_modes(const BoundaryConditions<dim>    &conditions,
               const Bodies                     &bodies,
               const hp::MappingCollection<dim> &mapping,
               const DoFHandler<dim>            &dof_handler,
               const std::vector<unsigned int>  &group_of_body,
               const double                      softest_spring)
    {
      const Triangulation<dim> &triangulation = dof_handler.get_triangulation();
      const MPI_Comm            communicator  = dof_handler.get_communicator();

      std::vector<RigidBodyModes<dim>> modes;
      for (const auto &box :
           boxes_of_groups(body_boxes(triangulation, bodies), group_of_body))
        modes.emplace_back(box.first, box.second);
      // of bodies of revolution only the translation along the axis is rigid
      if (bodies.cross_section.is_axisymmetric)
        for (RigidBodyModes<dim> &of_group : modes)
          {
            of_group.hold_rotation(Point<3>::unit_vector(2));
            of_group.hold(Point<dim>(), Point<dim>::unit_vector(0));
          }

      std::string error;
      for (const auto &node :
           find_held_nodes(mapping,
                           dof_handler,
                           bodies,
                           conditions.prescribed_displacements(),
                           0.,
                           error))
        for (const auto &row : node.second.rows)
          modes[group_of_body[node.second.body]].hold(node.second.position,
                                                      row.direction);
      throw_collectively(error, communicator);

      // the same on all ranks, and only its being zero counts
      for (const unsigned int c : conditions.reference_points())
        {
          const auto &condition = conditions.prescribed_displacements()[c];
          if (condition.active.contains(0.))
            hold_by_reference_point(condition.motion,
                                    modes[group_of_body[condition.body]]);
        }

      for (const Load<dim> &load : conditions.loads())
        if (load.type == BoundaryConditionType::spring)
          hold_by_spring(load,
                         triangulation,
                         softest_spring,
                         modes[group_of_body[load.body]]);

      for (const PeriodicBoundary &boundary : bodies.periodic_boundaries)
        modes[group_of_body[boundary.body]].tie(boundary.motion);
      for (RigidBodyModes<dim> &of_group : modes)
        of_group.sum_over_ranks(communicator);
      return modes;
    }
  } // namespace



  std::string
  FreeMotion::text() const
  {
    return (bodies.size() > 1 ? "bodies " : "body ") + quoted_list(bodies) +
           ": " + motion;
  }



  std::vector<std::string>
  describe(const std::vector<FreeMotion> &motions)
  {
    std::vector<std::string> lines;
    for (unsigned int m = 0; m < motions.size(); ++m)
      if (m > 0 && motions[m].bodies == motions[m - 1].bodies)
        lines.back() += ", " + motions[m].motion;
      else
        lines.push_back("held by contact alone: " + motions[m].text());
    return lines;
  }



  void
  join_groups(const std::set<unsigned int> &joined,
              std::vector<unsigned int>    &group_of_body)
  {
    for (unsigned int &group : group_of_body)
      if (joined.count(group) > 0)
        group = *joined.begin();
  }



  void
  number_groups(std::vector<unsigned int> &group_of_body)
  {
    const std::set<unsigned int> numbers(group_of_body.begin(),
                                         group_of_body.end());
    for (unsigned int &group : group_of_body)
      group = std::distance(numbers.begin(), numbers.find(group));
  }



  template <int dim>
  std::vector<unsigned int>
  groups_joined_by_cuts(const BoundaryConditions<dim> &conditions,
                        const Bodies                  &bodies)
  {
    std::vector<unsigned int> group(bodies.n_bodies());
    std::iota(group.begin(), group.end(), 0U);
    for (const auto &bolt : conditions.pretensions())
      join_groups({group[bolt.sides[0].body], group[bolt.sides[1].body]},
                  group);
    number_groups(group);
    return group;
  }



  template <int dim>
  std::vector<FreeMotion>
  free_rigid_motions(const BoundaryConditions<dim>    &conditions,
                     const Bodies                     &bodies,
                     const hp::MappingCollection<dim> &mapping,
                     const DoFHandler<dim>            &dof_handler,
                     const double                      softest_spring)
  {
    return free_motions_of_groups(conditions,
                                  bodies,
                                  mapping,
                                  dof_handler,
                                  groups_joined_by_cuts(conditions, bodies),
                                  softest_spring);
  }



  template <int dim>
  std::vector<FreeMotion>
  free_motions_of_groups(const BoundaryConditions<dim>    &conditions,
                         const Bodies                     &bodies,
                         const hp::MappingCollection<dim> &mapping,
                         const DoFHandler<dim>            &dof_handler,
                         const std::vector<unsigned int>  &group_of_body,
                         const double                      softest_spring)
  {
    const auto modes = held_modes(
      conditions, bodies, mapping, dof_handler, group_of_body, softest_spring);
    std::vector<FreeMotion> motions;
    for (unsigned int g = 0; g < modes.size(); ++g)
      {
        std::vector<std::string> names;
        bool                     is_held = false;
        for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
          if (group_of_body[b] == g)
            {
              names.push_back(bodies.bodies[b].name);
              is_held = is_held || (bodies.bodies[b].is_rigid &&
                                    !conditions.drives_rigid_body(b));
            }
        if (!is_held)
          for (const Vector<double> &motion : modes[g].unheld())
            {
              FreeMotion free{names, modes[g].motion_name(motion), {}, {}};
              free.factors.assign(motion.begin(), motion.end());
              for (unsigned int d = 0; d < dim; ++d)
                free.centre.push_back(modes[g].middle()[d]);
              motions.push_back(free);
            }
      }
    return motions;
  }



#define INSTANTIATE(dim)                                    \
  template std::vector<FreeMotion> free_rigid_motions(      \
    const BoundaryConditions<dim> &,                        \
    const Bodies &,                                         \
    const hp::MappingCollection<dim> &,                     \
    const DoFHandler<dim> &,                                \
    const double);                                          \
  template std::vector<FreeMotion> free_motions_of_groups(  \
    const BoundaryConditions<dim> &,                        \
    const Bodies &,                                         \
    const hp::MappingCollection<dim> &,                     \
    const DoFHandler<dim> &,                                \
    const std::vector<unsigned int> &,                      \
    const double);                                          \
  template std::vector<unsigned int> groups_joined_by_cuts( \
    const BoundaryConditions<dim> &, const Bodies &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
