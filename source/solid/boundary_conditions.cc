#include <stickslip/solid/boundary_conditions.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/axisymmetry.h>
#include <stickslip/solid/direction_parameters.h>
#include <stickslip/solid/displacement_constraints.h>
#include <stickslip/solid/held_images.h>
#include <stickslip/solid/rigid_body_conditions.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <iterator>
#include <memory>

namespace stickslip
{
  namespace
  {
    std::string
    boundary_condition_path(const std::string &name)
    {
      return "Boundary conditions/" + name;
    }
  } // namespace



  template <int dim>
  BoundaryConditions<dim>::BoundaryConditions(
    const NamedList<BoundaryConditionParameters> &parameters,
    const Bodies                                 &bodies,
    const Amplitudes                             &amplitudes)
    : bodies(bodies)
    , amplitudes(amplitudes)
  {
    for (const auto &named : parameters)
      add_condition(named.first, named.second);
    check_couplings_of_rigid_bodies(displacements, bodies);
    for (const auto &conditions :
         {holds_of_idle_rigid_bodies(displacements, bodies),
          conditions_on_axis<dim>(bodies)})
      displacements.insert(displacements.end(),
                           conditions.begin(),
                           conditions.end());
  }



  template <int dim>
  void
  BoundaryConditions<dim>::add_condition(
    const std::string                 &name,
    const BoundaryConditionParameters &parameters)
  {
    const std::string path = boundary_condition_path(name);
    parameters.check(path);
    if (bodies.cross_section.is_axisymmetric)
      check_is_axisymmetric(parameters, path);

    const unsigned int body = bodies.index_of(parameters.body, path + "/Body");
    const BoundaryConditionType type = parameters.type;

    if (bodies.bodies[body].is_rigid &&
        (type != BoundaryConditionType::rigid_motion ||
         !parameters.boundary.empty() || !parameters.where.empty() ||
         !parameters.active_from.empty() || !parameters.active_until.empty()))
      throw UserError(path + ": body '" + parameters.body +
                      "' is rigid. It takes a condition of type 'rigid "
                      "motion' without 'Boundary', 'Where', 'Active from' and "
                      "'Active until', and no other.");

    switch (type)
      {
        case BoundaryConditionType::displacement:
        case BoundaryConditionType::symmetry:
        case BoundaryConditionType::rigid_motion:
          add_displacement(name, parameters);
          break;
        case BoundaryConditionType::traction:
        case BoundaryConditionType::pressure:
        case BoundaryConditionType::follower_pressure:
        case BoundaryConditionType::spring:
        case BoundaryConditionType::body_force:
        case BoundaryConditionType::distributed_force:
          add_load(name, parameters);
          break;
        case BoundaryConditionType::periodic:
        case BoundaryConditionType::cyclic_symmetry:
          break; // Bodies::periodic_boundaries
        case BoundaryConditionType::pretension:
          all_pretensions.emplace_back(name,
                                       parameters,
                                       bodies,
                                       amplitude_of(parameters, path));
          break;
      }
  }



  template <int dim>
  std::shared_ptr<const Amplitude>
  BoundaryConditions<dim>::amplitude_of(
    const BoundaryConditionParameters &parameters,
    const std::string                 &path) const
  {
    return parameters.amplitude.empty() ? nullptr
                                        : amplitude_called(parameters.amplitude,
                                                           amplitudes,
                                                           path + "/Amplitude");
  }



  template <int dim>
  std::optional<CylindricalFrame<dim>>
  BoundaryConditions<dim>::frame_of(
    const BoundaryConditionParameters &parameters,
    const std::string                 &path)
  {
    if (parameters.components == VectorComponents::cartesian)
      return {};
    const auto [axis, centre] =
      axis_of<dim>(parameters.rotation_axis, parameters.rotation_centre, path);
    return CylindricalFrame<dim>(centre, axis);
  }



  template <int dim>
  void
  BoundaryConditions<dim>::add_displacement(
    const std::string                 &name,
    const BoundaryConditionParameters &parameters)
  {
    const std::string           path = boundary_condition_path(name);
    PrescribedDisplacement<dim> condition;
    condition.name = name;
    condition.type = parameters.type;
    condition.body = bodies.index_of(parameters.body, path + "/Body");
    if (!parameters.boundary.empty())
      condition.boundary_ids = bodies.global_boundary_ids(parameters.body,
                                                          parameters.boundary,
                                                          path + "/Boundary");
    condition.active = parameters.active_interval(path);
    condition.frame  = frame_of(parameters, path);
    if (condition.type == BoundaryConditionType::displacement)
      {
        const auto value = std::make_shared<SpaceTimeFunction<dim>>(
          parameters.value, dim, path + "/Value", true);
        value->multiply_by(amplitude_of(parameters, path));
        condition.value = value;
      }
    if (condition.type == BoundaryConditionType::rigid_motion)
      condition.motion =
        RigidMotion<dim>(parameters, amplitude_of(parameters, path), path);
    if (!parameters.where.empty())
      condition.where = std::make_shared<SpaceTimeFunction<dim>>(
        parameters.where, 1, path + "/Where", false, false);
    displacements.push_back(condition);
  }



  template <int dim>
  void
  BoundaryConditions<dim>::add_load(
    const std::string                 &name,
    const BoundaryConditionParameters &parameters)
  {
    const std::string path = boundary_condition_path(name);
    Load<dim>         load;
    load.name = name;
    load.type = parameters.type;
    load.body = bodies.index_of(parameters.body, path + "/Body");
    if (load.type != BoundaryConditionType::body_force)
      load.boundary_ids = bodies.global_boundary_ids(parameters.body,
                                                     parameters.boundary,
                                                     path + "/Boundary");

    load.active = parameters.active_interval(path);
    load.frame  = frame_of(parameters, path);
    if (load.type == BoundaryConditionType::spring)
      {
        load.stiffness = unit_symmetric_tensor<dim, double>();
        if (!parameters.direction.empty())
          {
            const Tensor<1, dim> d = parameters.unit_direction<dim>(path);
            load.stiffness         = outer_product(d, d);
          }
        load.stiffness *= parameters.stiffness;
      }
    else if (load.type == BoundaryConditionType::distributed_force)
      load.distribution =
        std::make_shared<ForceDistribution<dim>>(parameters,
                                                 amplitude_of(parameters, path),
                                                 path);
    else
      {
        const bool is_pressure =
          (load.type == BoundaryConditionType::pressure ||
           load.type == BoundaryConditionType::follower_pressure);
        const auto value =
          std::make_shared<SpaceTimeFunction<dim>>(parameters.value,
                                                   is_pressure ? 1 : dim,
                                                   path + "/Value");
        value->multiply_by(amplitude_of(parameters, path));
        load.value = value;
      }
    all_loads.push_back(load);
  }



  template <int dim>
  bool
  BoundaryConditions<dim>::drives_rigid_body(const unsigned int body) const
  {
    return bodies.bodies[body].is_rigid && has_coupling(displacements, body);
  }



  template <int dim>
  std::vector<unsigned int>
  BoundaryConditions<dim>::reference_points() const
  {
    std::vector<unsigned int> result;
    for (unsigned int c = 0; c < displacements.size(); ++c)
      if (displacements[c].is_coupling())
        result.push_back(c);
    return result;
  }



  template <int dim>
  void
  BoundaryConditions<dim>::add_prescribed_displacements(
    const hp::MappingCollection<dim> &mapping,
    const DoFHandler<dim>            &dof_handler,
    const PeriodicNodes<dim>         &periodic_nodes,
    const double                      time,
    const LA::Vector                 &u,
    Constraints                      &constraints) const
  {
    const MPI_Comm communicator = dof_handler.get_communicator();

    std::string error;
    auto        nodes =
      find_held_nodes(mapping, dof_handler, bodies, displacements, time, error);
    add_rows_of_images(periodic_nodes,
                       dof_handler.locally_owned_dofs(),
                       displacements,
                       time,
                       communicator,
                       nodes,
                       error);

    std::vector<ConstraintLine> lines;
    std::vector<unsigned int>   n_nodes(displacements.size(), 0);
    for (const auto &[first_dof, node] : nodes)
      {
        for (const auto &row : node.rows)
          ++n_nodes[row.condition];
        if (node.is_coupled())
          {
            ++n_nodes[node.coupling];
            check_coupled_node(node, displacements, time, error);
            continue;
          }
        // Hanging nodes and images follow others.
        if (constraints.is_constrained(first_dof))
          continue;
        Tensor<1, dim> u_node;
        for (unsigned int d = 0; d < dim; ++d)
          u_node[d] = u(node.dofs[d]);
        const std::vector<ConstraintLine> node_lines =
          resolve_held_node(node, u_node, displacements, error);
        lines.insert(lines.end(), node_lines.begin(), node_lines.end());
      }
    throw_collectively(error, communicator);

    const std::vector<unsigned int> n_local_nodes = n_nodes;
    Utilities::MPI::sum(n_local_nodes, communicator, n_nodes);
    for (unsigned int c = 0; c < displacements.size(); ++c)
      if (n_nodes[c] == 0 && displacements[c].active.contains(time))
        throw UserError(
          boundary_condition_path(displacements[c].name) +
          " holds no component of any node" +
          (displacements[c].where != nullptr
             ? ": 'Where' is zero at all nodes of its boundary, or "
               "others hold them already."
             : ": other conditions hold its nodes already."));

    add_lines_on_all_ranks(lines,
                           dof_handler.locally_owned_dofs(),
                           communicator,
                           constraints);
  }



  template <int dim>
  BoundaryConditions<dim>
  BoundaryConditions<dim>::permanent() const
  {
    BoundaryConditions<dim> result(*this);
    result.displacements.clear();
    std::copy_if(displacements.begin(),
                 displacements.end(),
                 std::back_inserter(result.displacements),
                 [](const auto &condition) {
                   return condition.active.is_always();
                 });
    return result;
  }



  template <int dim>
  bool
  BoundaryConditions<dim>::hold_the_same(const double time,
                                         const double other_time) const
  {
    return std::all_of(displacements.begin(),
                       displacements.end(),
                       [=](const auto &condition) {
                         return condition.active.contains(time) ==
                                condition.active.contains(other_time);
                       }) &&
           std::all_of(all_pretensions.begin(),
                       all_pretensions.end(),
                       [=](const auto &bolt) {
                         return bolt.is_drawn(time) ==
                                bolt.is_drawn(other_time);
                       });
  }



  template <int dim>
  void
  BoundaryConditions<dim>::measure_distributed_forces(
    const hp::MappingCollection<dim> &mapping,
    const DoFHandler<dim>            &dof_handler) const
  {
    for (const Load<dim> &load : all_loads)
      if (load.distribution)
        load.distribution->measure(mapping,
                                   dof_handler,
                                   load.boundary_ids,
                                   bodies.cross_section,
                                   displacements);
  }



  template class BoundaryConditions<2>;
  template class BoundaryConditions<3>;
} // namespace stickslip
