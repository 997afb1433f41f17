#include <stickslip/problem/contact_pairs.h>

#include <stickslip/base/over_ranks.h>
#include <stickslip/base/user_error.h>

#include <stickslip/problem/rigid_tools.h>

#include <set>
#include <string>

namespace stickslip
{
  namespace
  {
    /// First dofs of the relevant nodes all of whose displacements @p supports
    /// prescribe.
    template <int dim>
    std::set<types::global_dof_index>
    held_nodes(const DofLayout<dim>      &dofs,
               const PeriodicImages<dim> &images,
               const Constraints         &supports)
    {
      std::set<types::global_dof_index> held;
      for (const auto dof : dofs.relevant)
        {
          // the components of a node are neighbours
          bool is_held = dof % dim == 0;
          for (unsigned int c = 0; is_held && c < dim; ++c)
            is_held = supports.is_constrained(dof + c) &&
                      supports.get_constraint_entries(dof + c)->empty();
          if (is_held)
            held.insert(images.original(dof));
        }
      return held;
    }



    /// Sides of periodic boundaries are no surfaces of the body.
    void
    leave_out_cuts(const Bodies                 &bodies,
                   const std::string            &path,
                   std::set<types::boundary_id> &surface)
    {
      std::string of_condition;
      for (const PeriodicBoundary &boundary : bodies.periodic_boundaries)
        if (surface.erase(boundary.first) + surface.erase(boundary.second) > 0)
          of_condition = boundary.parameter_path;
      if (surface.empty() && !of_condition.empty())
        throw UserError("'" + path + "' has nothing but sides of '" +
                        of_condition +
                        "', which are cuts through the body: there is no "
                        "contact on them.");
    }



    /// The area all around of the function of an end node, if this is not
    /// linear, vanishes on a face that begins on the axis.
    template <int dim>
    void
    check_multipliers_on_axis(const ContactPair<dim> &pair,
                              const std::string      &path,
                              const MPI_Comm         &communicator)
    {
      const CrossSection &section    = pair.surfaces.cross_section;
      bool                found      = false;
      const auto         &parameters = pair.parameters;
      if (section.is_axisymmetric && pair.multiplier_shape.degree() > 1 &&
          has_one_multiplier_per_point(parameters.quadrature))
        for (const auto &slave : pair.slave_faces)
          for (const auto &X : slave.face.undeformed_nodes())
            found = found || section.is_on_axis(X);
      if (any_rank(found, communicator))
        throw UserError(
          "'" + path +
          (parameters.has_segments() ? "/Multiplier space = displacement trace'"
                                     : "/Quadrature = nodal'") +
          " does not work with Degree " +
          std::to_string(pair.multiplier_shape.degree()) +
          " where the slave surface reaches the axis of an axisymmetric model: "
          "a multiplier there has no area. Take '" +
          (parameters.has_segments() ? "automatic" : "segments") + "'.");
    }
  } // namespace



  template <int dim>
  std::vector<std::unique_ptr<ContactPair<dim>>>
  make_contact_pairs(
    const NamedList<ContactPairParameters>                &parameters,
    const Bodies                                          &bodies,
    const DofLayout<dim>                                  &dofs,
    const Constraints                                     &supports,
    const std::function<double(const types::material_id)> &modulus,
    const MPI_Comm                                        &communicator)
  {
    const auto images =
      std::make_shared<const PeriodicImages<dim>>(bodies.periodic_boundaries,
                                                  dofs.periodic_nodes,
                                                  communicator);
    std::vector<std::unique_ptr<ContactPair<dim>>> pairs;
    for (const auto &[name, pair] : parameters)
      {
        const std::string  path = "Contact/" + name;
        const unsigned int slave_body =
          bodies.index_of(pair.slave_body, path + "/Slave body");
        const unsigned int master_body =
          bodies.index_of(pair.master_body, path + "/Master body");
        const bool has_tool = bodies.bodies[master_body].parameters.is_tool();
        if (!pair.is_automatic && pair.master_boundary.empty() && !has_tool)
          throw UserError("'" + path +
                          "/Master boundary' is missing: a contact pair needs "
                          "Slave body, Slave boundary, Master body and Master "
                          "boundary (unless that is a rigid tool).");
        auto slave  = pair.is_automatic
                        ? pair.slave_ids
                        : bodies.global_boundary_ids(pair.slave_body,
                                                    pair.slave_boundary,
                                                    path + "/Slave boundary");
        auto master = pair.is_automatic ? pair.master_ids
                      : has_tool && pair.master_boundary.empty()
                        ? bodies.all_boundary_ids(master_body)
                        : bodies.global_boundary_ids(pair.master_body,
                                                     pair.master_boundary,
                                                     path + "/Master boundary");
        leave_out_cuts(bodies, path + "/Slave boundary", slave);
        leave_out_cuts(bodies, path + "/Master boundary", master);
        if (bodies.bodies[slave_body].is_rigid &&
            bodies.bodies[master_body].is_rigid)
          throw UserError("'" + path + "': both bodies, '" + pair.slave_body +
                          "' and '" + pair.master_body +
                          "', are rigid. At least one must be deformable.");
        PairSurfaces surfaces{slave,
                              master,
                              {},
                              bodies.all_boundary_ids(slave_body),
                              bodies.all_boundary_ids(master_body),
                              {},
                              bodies.cross_section,
                              bodies.bodies[slave_body].cells,
                              bodies.bodies[master_body].cells,
                              slave_body,
                              master_body};
        if (bodies.bodies[slave_body].parameters.is_tool())
          throw UserError("'" + path + "/Slave body = " + pair.slave_body +
                          "': a rigid tool has no contact points. Let it be "
                          "the master.");
        ToolMaster<dim> tool;
        if (has_tool)
          tool = make_tool_master(bodies.bodies[master_body].parameters,
                                  "Bodies/" + pair.master_body,
                                  master,
                                  dofs.dof_handler,
                                  communicator);
        if (!pair.excluded_boundaries.empty())
          surfaces.excluded =
            bodies.global_boundary_ids(pair.slave_body,
                                       pair.excluded_boundaries,
                                       path + "/Excluded boundaries");
        // a bond there would leave its multiplier to the master alone
        if (pair.is_bilateral() && !bodies.bodies[slave_body].is_rigid)
          surfaces.excluded_nodes = held_nodes(dofs, *images, supports);
        pairs.push_back(std::make_unique<ContactPair<dim>>(name,
                                                           pair,
                                                           surfaces,
                                                           dofs.mapping,
                                                           dofs.dof_handler,
                                                           supports,
                                                           modulus,
                                                           tool,
                                                           images,
                                                           communicator));
        check_multipliers_on_axis(*pairs.back(), path, communicator);
      }
    return pairs;
  }

#define INSTANTIATE(dim)                                                      \
  template std::vector<std::unique_ptr<ContactPair<dim>>> make_contact_pairs( \
    const NamedList<ContactPairParameters> &,                                 \
    const Bodies &,                                                           \
    const DofLayout<dim> &,                                                   \
    const Constraints &,                                                      \
    const std::function<double(const types::material_id)> &,                  \
    const MPI_Comm &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
