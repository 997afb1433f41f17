#include <stickslip/problem/contact_problem.h>

#include <stickslip/base/no_convergence.h>
#include <stickslip/base/over_ranks.h>
#include <stickslip/base/user_error.h>

#include <stickslip/contact/assembly/contact_scales.h>
#include <stickslip/contact/assembly/nodal_frames.h>
#include <stickslip/contact/assembly/restrained_directions.h>

#include <stickslip/problem/contact_pairs.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Displacements up to this fraction of the extent of the model are
    /// roundoff.
    constexpr double roundoff_of_positions = 1e-12;
  } // namespace



  template <int dim>
  ContactProblem<dim>::ContactProblem(
    Mesh<dim>                                    &mesh,
    const unsigned int                            degree,
    const NamedList<MaterialParameters>          &materials,
    const NamedList<BoundaryConditionParameters> &conditions,
    const NamedList<ContactPairParameters>       &contact_pairs,
    const bool                                    quasi_tangent,
    const Amplitudes                             &amplitudes)
    : mesh(mesh)
    , communicator(mesh.triangulation->get_communicator())
    , dofs(*mesh.triangulation, degree, mesh.bodies.periodic_boundaries)
    , quasi_tangent(quasi_tangent)
    , boundary_conditions(conditions, mesh.bodies, amplitudes)
  {
    solid_assembler = std::make_unique<SolidAssembler<dim>>(
      dofs.mapping,
      dofs.dof_handler,
      mesh.bodies,
      laws_of_regions(materials, mesh.bodies),
      boundary_conditions,
      mean_dilatation_of_regions(materials, mesh.bodies));
    const auto modulus_of = [&](const types::material_id material) {
      return mesh.bodies.bodies[mesh.bodies.body_of(material)].is_rigid
               ? std::numeric_limits<double>::infinity()
               : solid_assembler->longitudinal_modulus(material);
    };
    const Constraints supports = lasting_supports();
    contact_assembler          = std::make_unique<ContactAssembler<dim>>(
      make_contact_pairs(
        contact_pairs, mesh.bodies, dofs, supports, modulus_of, communicator),
      dofs.owned,
      dofs.relevant,
      communicator);
    constraints = std::make_unique<ProblemConstraints<dim>>(
      dofs, mesh.bodies, boundary_conditions, *contact_assembler, communicator);
    sparsity           = std::make_unique<ProblemSparsity<dim>>(dofs,
                                                      *contact_assembler,
                                                      communicator);
    system_description = std::make_unique<SystemDescription<dim>>(
      dofs, mesh.bodies, *contact_assembler, communicator);

    const auto configure_contact = [this](const LA::BlockVector &x,
                                          const bool             may_fetch) {
      configure(x, may_fetch);
      // only a refresh of the frozen geometry asks for new patches
      if (may_fetch)
        ++counts.pairings;
    };
    geometry = std::make_unique<ContactGeometry<dim>>(*contact_assembler,
                                                      configure_contact);
    threshold =
      std::make_unique<FrictionThresholdField<dim>>(*contact_assembler,
                                                    configure_contact);
    status = std::make_unique<ContactStatusField<dim>>(*contact_assembler,
                                                       configure_contact);

    // Forces are measured against at least this one: the largest modulus at a
    // strain of 1e-8 over the extent of the model, far above the roundoff of a
    // body that only moves.
    const auto box     = GridTools::compute_bounding_box(*mesh.triangulation);
    double     modulus = 0.;
    for (unsigned int m = 0; m < mesh.bodies.regions.size(); ++m)
      modulus = std::max(modulus, solid_assembler->longitudinal_modulus(m));
    extent = box.get_boundary_points().first.distance(
      box.get_boundary_points().second);
    extent      = Utilities::MPI::max(extent, communicator);
    force_floor = 1e-8 * modulus * std::pow(extent, dim - 1) *
                  mesh.bodies.cross_section.circumference(
                    extent * Point<dim>::unit_vector(0));
    // A spring on one side of a body is lost in the roundoff of its matrix.
    softest_spring = 1e-11 * modulus / extent;
    for (const auto &pair : contact_assembler->contact_pairs())
      if (pair->mortar)
        pair->mortar->find_symmetry_planes(supports, pair->points);
    contact_start = look_at_contact(*contact_assembler, dofs);
    x_old         = zero_state();
    unbalanced    = x_old.block(0);
    solid_assembler->stabilization().set_start(u_old);
  }



  template <int dim>
  Constraints
  ContactProblem<dim>::lasting_supports() const
  {
    Constraints supports(dofs.relevant);
    boundary_conditions.permanent().add_prescribed_displacements(
      dofs.mapping,
      dofs.dof_handler,
      dofs.periodic_nodes,
      time,
      LA::Vector(dofs.owned, communicator),
      supports);
    supports.close();
    return supports;
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
    u_old = x_old.block(0);
    constraints->invalidate();
  }



  template <int dim>
  bool
  ContactProblem<dim>::is_configured_for(const LA::BlockVector &x,
                                         const bool may_fetch_patches) const
  {
    bool is_same = is_configured &&
                   configured_live == contact_assembler->live.geometry &&
                   (patches_were_checked || !may_fetch_patches);
    for (unsigned int b = 0; is_same && b < x.n_blocks(); ++b)
      is_same = configured_x.block(b) == x.block(b); // of this rank
    return all_ranks(is_same, communicator);
  }



  template <int dim>
  void
  ContactProblem<dim>::configure(const LA::BlockVector &x,
                                 const bool             may_fetch_patches)
  {
    if (is_configured_for(x, may_fetch_patches))
      return;
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
    contact_assembler->configure(u, u_old, lambda);
    if (contact_assembler->live.geometry)
      ++counts.pairings;
    is_configured        = true;
    configured_x         = x;
    configured_live      = contact_assembler->live.geometry;
    patches_were_checked = may_fetch_patches;
    counts.contact_seconds += timer.wall_time();
  }



  template <int dim>
  void
  ContactProblem<dim>::begin_step(const double           new_time,
                                  const LA::BlockVector &accepted)
  {
    if (!boundary_conditions.hold_the_same(time, new_time))
      sparsity->invalidate();
    time  = new_time;
    x_old = accepted;
    forget_state();
    for (const auto &pair : contact_assembler->contact_pairs())
      pair->update_gap_offsets(time);
    if (u_old.size() > 0)
      u_old = x_old.block(0);
  }



  template <int dim>
  void
  ContactProblem<dim>::begin_iteration(const LA::BlockVector &x)
  {
    configure(x, contact_assembler->live.geometry);
    contact_assembler->accept_iterate();
    update_contact_scales(*contact_assembler);
    constraints->update(time, x.block(0), /*is_accepted=*/true);
    update_nodal_frames(*contact_assembler);
    LA::Vector accepted(lambda);
    accepted = x_old.block(1);
    update_restrained_directions(*contact_assembler,
                                 constraints->increment(),
                                 accepted);
  }



  template <int dim>
  ResidualNorms
  ContactProblem<dim>::residual(const LA::BlockVector &x)
  {
    configure(x, contact_assembler->live.geometry);
    constraints->update(time, x.block(0));
    Timer           timer;
    LA::BlockVector internal = zero_state(), external = zero_state(),
                    contact = zero_state();
    ContactRowSizes row_sizes(contact.block(1));
    solid_assembler->add_residual(
      u, time, constraints->geometric(), internal.block(0), external.block(0));
    internal.compress(VectorOperation::add);
    external.compress(VectorOperation::add);
    counts.assembly_seconds += timer.wall_time();
    timer.restart();
    contact_assembler->add_residual(constraints->geometric(),
                                    contact,
                                    row_sizes);
    contact.compress(VectorOperation::add);
    row_sizes.compress();
    counts.contact_seconds += timer.wall_time();

    forces = internal.block(0);
    forces += contact.block(0);
    forces_of_contact = contact.block(0);
    unbalanced        = forces;
    unbalanced -= external.block(0);
    LA::Vector imbalance = unbalanced;
    imbalance -= constraints->driving_forces(time, true);
    external.block(0) += constraints->driving_forces(time, false);

    if (std::isnan(external.block(0).l2_norm()))
      throw UserError(
        "A load (traction, pressure, spring or body force in 'Boundary "
        "conditions') is not a number at time " +
        std::to_string(time) + ".");
    ResidualNorms norms = residual_norms(
      {imbalance, external.block(0), contact.block(1), row_sizes},
      constraints->increment(),
      force_floor,
      communicator);
    norms.prescribed = constraints->unapplied_displacement();
    return norms;
  }



  template <int dim>
  double
  ContactProblem<dim>::negligible_unknown(const unsigned int b) const
  {
    return b == 0 ? roundoff_of_positions * extent
                  : negligible_pressure(*contact_assembler);
  }



  template <int dim>
  void
  ContactProblem<dim>::assemble(const LA::BlockVector &x)
  {
    configure(x, contact_assembler->live.geometry);
    constraints->update(time, x.block(0));
    Timer timer;
    if (constraints->has_new_masters())
      sparsity->invalidate();
    if (sparsity->update(constraints->increment(), system_matrix))
      {
        rhs = zero_state();
        system_description->new_sparsity();
        ++counts.sparsity_rebuilds;
      }
    system_matrix = 0.;
    rhs           = 0.;
    solid_assembler->add_tangent(u,
                                 time,
                                 constraints->increment(),
                                 system_matrix.block(0, 0),
                                 rhs.block(0));
    constraints->add_driving_terms(time, unbalanced, system_matrix, rhs);
    counts.assembly_seconds += timer.wall_time();
    timer.restart();
    contact_assembler->add_tangent(constraints->increment(),
                                   !quasi_tangent,
                                   system_matrix,
                                   rhs);
    // rows that nothing fills: excluded nodes and nodes without any point
    const types::global_dof_index n_u = dofs.owned.size();
    for (const auto i : contact_assembler->multipliers().locally_owned())
      if (constraints->increment().is_constrained(n_u + i))
        system_matrix.block(1, 1).add(i, i, 1.);
    system_matrix.compress(VectorOperation::add);
    rhs.compress(VectorOperation::add);
    counts.contact_seconds += timer.wall_time();
  }



  template <int dim>
  const BlockSystemDescription &
  ContactProblem<dim>::describe_system()
  {
    return system_description->update(constraints->increment());
  }



  template <int dim>
  void
  ContactProblem<dim>::distribute(LA::BlockVector &increment) const
  {
    constraints->increment().distribute(increment);
  }



  template <int dim>
  void
  ContactProblem<dim>::accept_step(const LA::BlockVector &x)
  {
    residual(x);
    solid_assembler->accept();
    contact_assembler->accept_step();
    is_configured &= !contact_assembler->choose_sides();
  }



  template <int dim>
  void
  ContactProblem<dim>::restore()
  {
    solid_assembler->restore();
    contact_assembler->restore();
    is_configured = false;
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace stickslip
