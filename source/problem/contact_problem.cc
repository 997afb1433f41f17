#include <stickslip/base/no_convergence.h>
#include <stickslip/base/user_error.h>

#include <stickslip/contact/contact_scales.h>

#include <stickslip/problem/contact_problem.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <limits>

namespace stickslip
{
  template <int dim>
  ContactProblem<dim>::ContactProblem(
    Mesh<dim>                                    &mesh,
    const unsigned int                            degree,
    const NamedList<MaterialParameters>          &materials,
    const NamedList<BoundaryConditionParameters> &conditions,
    const NamedList<ContactPairParameters>       &contact_pairs,
    const bool                                    quasi_tangent)
    : mesh(mesh)
    , communicator(mesh.triangulation->get_communicator())
    , dofs(*mesh.triangulation, degree)
    , quasi_tangent(quasi_tangent)
    , boundary_conditions(conditions, mesh.bodies)
  {
    solid_assembler =
      std::make_unique<SolidAssembler<dim>>(dofs.mapping,
                                            dofs.dof_handler,
                                            mesh.bodies,
                                            laws_of_regions(materials,
                                                            mesh.bodies),
                                            boundary_conditions);
    make_contact_pairs(contact_pairs);

    const auto configure_contact = [this](const LA::BlockVector &x,
                                          const bool             may_fetch) {
      configure(x, may_fetch);
    };
    geometry  = std::make_unique<ContactGeometry<dim>>(*contact_assembler,
                                                      configure_contact);
    threshold = std::make_unique<FrictionThreshold<dim>>(*contact_assembler,
                                                         configure_contact);
    status    = std::make_unique<ContactStatusField<dim>>(*contact_assembler,
                                                       configure_contact);

    // A force that counts as none: the smallest modulus at a strain of 1e-12
    // over the extent of the model.
    const auto box     = GridTools::compute_bounding_box(*mesh.triangulation);
    double     modulus = std::numeric_limits<double>::max();
    for (unsigned int m = 0; m < mesh.bodies.regions.size(); ++m)
      if (solid_assembler->longitudinal_modulus(m) > 0.)
        modulus = std::min(modulus, solid_assembler->longitudinal_modulus(m));
    double extent = box.get_boundary_points().first.distance(
      box.get_boundary_points().second);
    extent      = Utilities::MPI::max(extent, communicator);
    force_floor = 1e-12 * modulus * std::pow(extent, dim - 1);
    x_old       = zero_state();
  }



  template <int dim>
  void
  ContactProblem<dim>::make_contact_pairs(
    const NamedList<ContactPairParameters> &parameters)
  {
    std::vector<std::unique_ptr<ContactPair<dim>>> pairs;
    const auto modulus = [this](const types::material_id material) {
      return mesh.bodies.bodies[mesh.bodies.body_of(material)].is_rigid
               ? std::numeric_limits<double>::infinity()
               : solid_assembler->longitudinal_modulus(material);
    };
    for (const auto &[name, pair] : parameters)
      {
        const std::string path   = "Contact/" + name;
        const auto       &bodies = mesh.bodies;
        const auto        slave  = bodies.global_boundary_ids(pair.slave_body,
                                                      pair.slave_boundary,
                                                      path + "/Slave boundary");
        const auto        master =
          bodies.global_boundary_ids(pair.master_body,
                                     pair.master_boundary,
                                     path + "/Master boundary");
        const unsigned int slave_body =
          bodies.index_of(pair.slave_body, path + "/Slave body");
        const unsigned int master_body =
          bodies.index_of(pair.master_body, path + "/Master body");
        if (bodies.bodies[slave_body].is_rigid &&
            bodies.bodies[master_body].is_rigid)
          throw UserError("'" + path + "': both bodies, '" + pair.slave_body +
                          "' and '" + pair.master_body +
                          "', are rigid. At least one must be deformable.");
        std::set<types::boundary_id> excluded;
        if (!pair.excluded_boundaries.empty())
          excluded = bodies.global_boundary_ids(pair.slave_body,
                                                pair.excluded_boundaries,
                                                path + "/Excluded boundaries");
        master_is_rigid.push_back(bodies.bodies[master_body].is_rigid);
        pairs.push_back(std::make_unique<ContactPair<dim>>(name,
                                                           pair,
                                                           slave,
                                                           master,
                                                           excluded,
                                                           dofs.mapping,
                                                           dofs.dof_handler,
                                                           modulus,
                                                           communicator));
      }
    contact_assembler = std::make_unique<ContactAssembler<dim>>(
      std::move(pairs), dofs.owned, dofs.relevant, communicator);
  }



  template <int dim>
  LA::BlockVector
  ContactProblem<dim>::zero_state() const
  {
    return LA::BlockVector({dofs.owned,
                            contact_assembler->multipliers().locally_owned()},
                           communicator);
  }



  template <int dim>
  std::array<FreezableQuantity *, 3>
  ContactProblem<dim>::quantities()
  {
    return {{geometry.get(), threshold.get(), status.get()}};
  }



  template <int dim>
  void
  ContactProblem<dim>::update_ghost_layout()
  {
    const IndexSet needed = contact_assembler->needed_displacements();
    u.reinit(dofs.owned, needed, communicator);
    u_old.reinit(dofs.owned, needed, communicator);
    u_old                       = x_old.block(0);
    pattern_is_outdated         = true;
    constraints_are_homogeneous = false;
    known_couplings.clear();
  }



  template <int dim>
  void
  ContactProblem<dim>::configure(const LA::BlockVector &x,
                                 const bool             may_fetch_patches)
  {
    Timer timer;
    if (u.size() == 0)
      {
        const auto &multipliers = contact_assembler->multipliers();
        u.reinit(dofs.owned, dofs.relevant, communicator);
        u = x.block(0);
        contact_assembler->update_patches(u, true);
        update_ghost_layout();
        lambda.reinit(multipliers.locally_owned(),
                      multipliers.locally_relevant(),
                      communicator);
      }
    u = x.block(0);
    if (may_fetch_patches && contact_assembler->update_patches(u, false))
      {
        update_ghost_layout();
        u = x.block(0);
      }
    lambda = x.block(1);
    contact_assembler->configure(u, u_old, lambda, time);
    if (contact_assembler->live.geometry)
      ++counts.pairings;
    counts.contact_seconds += timer.wall_time();
  }



  template <int dim>
  void
  ContactProblem<dim>::begin_step(const double           new_time,
                                  const LA::BlockVector &accepted)
  {
    time                        = new_time;
    x_old                       = accepted;
    constraints_are_homogeneous = false;
    if (u_old.size() > 0)
      u_old = x_old.block(0);
  }



  template <int dim>
  void
  ContactProblem<dim>::begin_iteration(const LA::BlockVector &x)
  {
    configure(x, contact_assembler->live.geometry);
    update_contact_scales(*contact_assembler);
    update_constraints(x);
  }



  template <int dim>
  void
  ContactProblem<dim>::constrain_multipliers(Constraints &lines) const
  {
    const types::global_dof_index n_u   = dofs.owned.size();
    const auto                   &pairs = contact_assembler->contact_pairs();
    const auto                   &numbering = contact_assembler->multipliers();
    for (const MultiplierNode &node : numbering.relevant_nodes())
      {
        const ContactPair<dim> &pair   = *pairs[node.pair];
        const unsigned int      n_comp = pair.n_multiplier_components();
        bool is_excluded = pair.excluded_keys().count(node.key) > 0;
        // a node that cannot move against a master that cannot move
        if (master_is_rigid[node.pair])
          {
            bool is_held = true;
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto *entries =
                  lines.is_constrained(node.key + c)
                    ? lines.get_constraint_entries(node.key + c)
                    : nullptr;
                is_held = is_held && entries != nullptr && entries->empty();
              }
            is_excluded = is_excluded || is_held;
          }
        // hanging and periodic nodes have no multipliers of their own
        const auto *entries = geometric.is_constrained(node.key)
                                ? geometric.get_constraint_entries(node.key)
                                : nullptr;
        for (unsigned int c = 0; c < n_comp; ++c)
          {
            const auto dof = n_u + node.first_dof + c;
            if (is_excluded)
              lines.add_line(dof);
            else if (entries != nullptr && !entries->empty())
              {
                lines.add_line(dof);
                for (const auto &[key, weight] : *entries)
                  if (numbering.has_node(node.pair, key))
                    lines.add_entry(dof,
                                    n_u + numbering.first_dof(node.pair, key) +
                                      c,
                                    weight);
              }
          }
      }
  }



  template <int dim>
  void
  ContactProblem<dim>::update_constraints(const LA::BlockVector &x)
  {
    if (constraints_are_homogeneous)
      return;
    const auto    &multipliers = contact_assembler->multipliers();
    const IndexSet needed      = contact_assembler->needed_displacements();

    Constraints displacement_lines(needed);
    DoFTools::make_hanging_node_constraints(dofs.dof_handler,
                                            displacement_lines);
    boundary_conditions.add_periodicity(dofs.dof_handler, displacement_lines);
    const IndexSet local =
      combined_index_set(needed, multipliers.locally_relevant());
    geometric.reinit(local);
    copy_lines(displacement_lines, geometric);

    boundary_conditions.add_prescribed_displacements(
      dofs.mapping, dofs.dof_handler, time, x.block(0), displacement_lines);
    displacement_lines.close();
    constraints.reinit(local);
    copy_lines(displacement_lines, constraints);
    constrain_multipliers(constraints);
    constraints.close();

    geometric.close();

    unapplied_displacement = 0.;
    for (const auto i : dofs.owned)
      if (constraints.is_inhomogeneously_constrained(i))
        unapplied_displacement =
          std::max(unapplied_displacement,
                   std::abs(constraints.get_inhomogeneity(i)));
    unapplied_displacement =
      Utilities::MPI::max(unapplied_displacement, communicator);
    const double largest = x.block(0).linfty_norm();
    // what is left of a fully applied displacement is roundoff
    if (unapplied_displacement <= 1e-14 * largest)
      unapplied_displacement = 0.;
    constraints_are_homogeneous = unapplied_displacement == 0.;
  }



  template <int dim>
  ResidualNorms
  ContactProblem<dim>::residual(const LA::BlockVector &x)
  {
    configure(x, contact_assembler->live.geometry);
    update_constraints(x);
    Timer           timer;
    LA::BlockVector internal = zero_state(), external = zero_state(),
                    contact = zero_state();
    LA::Vector row_scale(contact.block(1));
    solid_assembler->add_residual(
      u, time, geometric, internal.block(0), external.block(0));
    internal.compress(VectorOperation::add);
    external.compress(VectorOperation::add);
    counts.assembly_seconds += timer.wall_time();
    timer.restart();
    contact_assembler->add_residual(geometric, contact, row_scale);
    contact.compress(VectorOperation::add);
    row_scale.compress(VectorOperation::add);
    counts.contact_seconds += timer.wall_time();

    forces = internal.block(0);
    forces += contact.block(0);

    std::array<double, 3> squares{}; // imbalance, reactions, loads
    for (const auto i : dofs.owned)
      {
        const double r = forces(i) - external.block(0)(i);
        squares[constraints.is_constrained(i) ? 1 : 0] += r * r;
        squares[2] += external.block(0)(i) * external.block(0)(i);
      }
    double                        largest = 0.;
    const types::global_dof_index n_u     = dofs.owned.size();
    for (const auto i : contact.block(1).locally_owned_elements())
      if (!constraints.is_constrained(n_u + i) && row_scale(i) > 0.)
        largest =
          std::max(largest, std::abs(contact.block(1)(i)) / row_scale(i));
    Utilities::MPI::sum(ArrayView<const double>(squares.data(), squares.size()),
                        communicator,
                        ArrayView<double>(squares.data(), squares.size()));

    ResidualNorms norms;
    norms.equilibrium =
      std::sqrt(squares[0]) /
      std::max({std::sqrt(squares[1]), std::sqrt(squares[2]), force_floor});
    norms.contact    = Utilities::MPI::max(largest, communicator);
    norms.prescribed = unapplied_displacement;
    return norms;
  }



  template <int dim>
  bool
  ContactProblem<dim>::couplings_are_known()
  {
    unsigned int n_new = 0;
    const auto  &pairs = contact_assembler->contact_pairs();
    for (unsigned int p = 0; p < pairs.size(); ++p)
      for (const auto &point : pairs[p]->points)
        if (point.frame.paired)
          n_new += known_couplings
                     .emplace(p,
                              point.slave_face,
                              pairs[p]->patch->face(point.frame.face).id)
                     .second;
    return Utilities::MPI::sum(n_new, communicator) == 0;
  }



  template <int dim>
  void
  ContactProblem<dim>::update_sparsity()
  {
    // Couplings are only ever added while the patches stay the same, so a node
    // that hops between facets costs one rebuild, not one per hop.
    if (couplings_are_known() && !pattern_is_outdated)
      return;
    pattern_is_outdated                     = false;
    const auto                 &multipliers = contact_assembler->multipliers();
    const std::vector<IndexSet> owned       = {dofs.owned,
                                               multipliers.locally_owned()};
    const std::vector<IndexSet> writable    = {
         contact_assembler->needed_displacements(),
         multipliers.locally_relevant()};
    TrilinosWrappers::BlockSparsityPattern pattern(owned,
                                                   owned,
                                                   writable,
                                                   communicator);
    std::vector<types::global_dof_index>   cell_dofs(dofs.fe.n_dofs_per_cell());
    for (const auto &cell : dofs.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(cell_dofs);
          constraints.add_entries_local_to_global(cell_dofs, pattern, false);
        }
    const types::global_dof_index n_u   = dofs.owned.size();
    const auto                   &pairs = contact_assembler->contact_pairs();
    std::vector<types::global_dof_index> coupled;
    for (const auto &[p, f, id] : known_couplings)
      {
        const auto &slave = pairs[p]->slave_faces[f];
        coupled           = slave.face.dofs;
        const auto &master =
          pairs[p]->patch->face(pairs[p]->patch->index_of(id)).dofs;
        coupled.insert(coupled.end(), master.begin(), master.end());
        for (const auto dof : slave.multiplier_dofs)
          coupled.push_back(n_u + dof);
        constraints.add_entries_local_to_global(coupled, pattern, false);
      }
    // open and unpaired points have rows of their own
    for (const auto &pair : pairs)
      for (const auto &slave : pair->slave_faces)
        {
          coupled = slave.face.dofs;
          for (const auto dof : slave.multiplier_dofs)
            coupled.push_back(n_u + dof);
          constraints.add_entries_local_to_global(coupled, pattern, false);
        }
    for (const auto i : multipliers.locally_owned())
      pattern.block(1, 1).add(i, i);
    pattern.compress();
    system_matrix.clear();
    system_matrix.reinit(pattern);
    rhs = zero_state();
    ++counts.sparsity_rebuilds;
  }



  template <int dim>
  void
  ContactProblem<dim>::assemble(const LA::BlockVector &x)
  {
    configure(x, contact_assembler->live.geometry);
    update_constraints(x);
    Timer timer;
    update_sparsity();
    system_matrix = 0.;
    rhs           = 0.;
    solid_assembler->add_tangent(
      u, time, constraints, system_matrix.block(0, 0), rhs.block(0));
    counts.assembly_seconds += timer.wall_time();
    timer.restart();
    contact_assembler->add_tangent(constraints,
                                   !quasi_tangent,
                                   system_matrix,
                                   rhs);
    // rows that nothing fills: excluded nodes and nodes without any point
    const types::global_dof_index n_u = dofs.owned.size();
    for (const auto i : contact_assembler->multipliers().locally_owned())
      if (constraints.is_constrained(n_u + i))
        system_matrix.block(1, 1).add(i, i, 1.);
    system_matrix.compress(VectorOperation::add);
    rhs.compress(VectorOperation::add);
    counts.contact_seconds += timer.wall_time();
  }



  template <int dim>
  void
  ContactProblem<dim>::distribute(LA::BlockVector &increment) const
  {
    constraints.distribute(increment);
  }



  template <int dim>
  bool
  ContactProblem<dim>::state_is_admissible(std::string &reason) const
  {
    if (solid_assembler->state_is_admissible())
      return true;
    reason = solid_assembler->inadmissible_point();
    return false;
  }



  template <int dim>
  void
  ContactProblem<dim>::accept_step(const LA::BlockVector &x)
  {
    residual(x);
    solid_assembler->accept();
    contact_assembler->accept_step();
  }



  template <int dim>
  void
  ContactProblem<dim>::restore()
  {
    solid_assembler->restore();
  }



  template <int dim>
  void
  ContactProblem<dim>::check_bodies_are_held() const
  {
    std::set<std::string> in_contact;
    for (const auto &pair : contact_assembler->contact_pairs())
      {
        in_contact.insert(pair->parameters.slave_body);
        in_contact.insert(pair->parameters.master_body);
      }
    std::string text;
    for (const std::string &motion :
         boundary_conditions.unheld_rigid_motions(dofs.mapping,
                                                  dofs.dof_handler))
      {
        bool may_be_held_by_contact = false;
        for (const std::string &body : in_contact)
          may_be_held_by_contact =
            may_be_held_by_contact ||
            motion.find("'" + body + "'") != std::string::npos;
        if (!may_be_held_by_contact)
          text += "\n  " + motion;
      }
    if (!text.empty())
      throw UserError(
        "These rigid body motions are held by no boundary "
        "condition, spring or contact pair:" +
        text + "\nAdd a condition in section 'Boundary conditions'.");
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace stickslip
