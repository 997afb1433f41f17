#include <stickslip/problem/problem_constraints.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/displacement_constraints.h>
#include <stickslip/solid/held_images.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace stickslip
{
  namespace
  {
    /// Those that this rank owns.
    template <int dim>
    IndexSet
    dofs_of_rigid_bodies(const DofLayout<dim> &dofs, const Bodies &bodies)
    {
      IndexSet                             rigid(dofs.owned.size());
      std::vector<types::global_dof_index> of_cell;
      for (const auto &cell : dofs.dof_handler.active_cell_iterators())
        if (!cell->is_artificial() &&
            bodies.bodies[bodies.body_of(cell->material_id())].is_rigid)
          {
            of_cell.resize(cell->get_fe().n_dofs_per_cell());
            cell->get_dof_indices(of_cell);
            rigid.add_indices(of_cell.begin(), of_cell.end());
          }
      return rigid & dofs.owned;
    }
  } // namespace



  template <int dim>
  ProblemConstraints<dim>::ProblemConstraints(
    const DofLayout<dim>          &dofs,
    const Bodies                  &bodies,
    const BoundaryConditions<dim> &boundary_conditions,
    const ContactAssembler<dim>   &contact,
    const MPI_Comm                &communicator)
    : dofs(dofs)
    , boundary_conditions(boundary_conditions)
    , contact(contact)
    , multiplier_constraints(bodies, boundary_conditions, contact)
    , communicator(communicator)
  {
    rigid_dofs = dofs_of_rigid_bodies(dofs, bodies);
    find_couplings(bodies);
  }



  template <int dim>
  void
  ProblemConstraints<dim>::find_couplings(const Bodies &bodies)
  {
    const auto  points = boundary_conditions.reference_points();
    const auto &bolts  = boundary_conditions.pretensions();
    if (points.empty() && bolts.empty())
      return;
    auto conditions = boundary_conditions.prescribed_displacements();
    for (auto &condition : conditions)
      condition.active = ActiveInterval();
    std::string error;
    auto        nodes = find_held_nodes(
      dofs.mapping, dofs.dof_handler, bodies, conditions, 0., error);
    add_rows_of_images(dofs.periodic_nodes,
                       dofs.owned,
                       conditions,
                       0.,
                       communicator,
                       nodes,
                       error);
    throw_collectively(error, communicator);

    Constraints geometric = geometric_lines_seen();
    geometric.close();
    for (const unsigned int c : points)
      {
        std::vector<HeldNode<dim>> of_point;
        for (const auto &[first_dof, node] : nodes)
          if (node.coupling == c)
            of_point.push_back(node);
        rigid_couplings.emplace_back(
          boundary_conditions.prescribed_displacements()[c],
          of_point,
          geometric,
          communicator);
      }
    for (const Pretension<dim> &bolt : bolts)
      cuts.emplace_back(bolt,
                        dofs.mapping,
                        dofs.dof_handler,
                        bodies,
                        nodes,
                        boundary_conditions.prescribed_displacements(),
                        geometric);
    for (unsigned int i = 0; i < cuts.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (cuts[i].shares_nodes_with(cuts[j]))
          throw UserError("Boundary conditions/" + cuts[j].name() +
                          " and Boundary conditions/" + cuts[i].name() +
                          ": these cuts have nodes in common. Leave cells "
                          "between them, and name each cut once.");
  }



  template <int dim>
  IndexSet
  ProblemConstraints<dim>::with_masters(IndexSet displacements) const
  {
    for (const auto &coupling : rigid_couplings)
      displacements.add_indices(coupling.masters().begin(),
                                coupling.masters().end());
    for (const auto &cut : cuts)
      displacements.add_indices(cut.masters());
    displacements.compress();
    return displacements;
  }



  template <int dim>
  void
  ProblemConstraints<dim>::add_displacement_lines(
    const double                           time,
    const LA::Vector                      &displacement,
    const std::vector<RigidCoupling<dim>> &couplings,
    Constraints                           &lines) const
  {
    // first: what else holds a node of a second side holds the opposite one
    for (const auto &cut : cuts)
      add_lines_on_all_ranks(cut.lines(time), dofs.owned, communicator, lines);
    boundary_conditions.add_prescribed_displacements(dofs.mapping,
                                                     dofs.dof_handler,
                                                     dofs.periodic_nodes,
                                                     time,
                                                     displacement,
                                                     lines);
    for (const auto &coupling : couplings)
      if (coupling.is_active(time))
        add_lines_on_all_ranks(coupling.lines(displacement),
                               dofs.owned,
                               communicator,
                               lines);
  }



  /// The cells of this rank do not show how nodes of distant master faces are
  /// constrained; their owners know. Closed first: what such a node hangs on
  /// may be constrained, too, and out of sight.
  template <int dim>
  Constraints
  ProblemConstraints<dim>::known_where_needed(const Constraints &seen) const
  {
    Constraints closed(seen);
    closed.close();
    const IndexSet needed = with_masters(contact.needed_displacements());
    Constraints    known(needed);
    copy_lines(closed, known);
    known.make_consistent_in_parallel(dofs.owned, needed, communicator);
    known.close();
    return known;
  }



  template <int dim>
  Constraints
  ProblemConstraints<dim>::geometric_lines_seen() const
  {
    Constraints lines(with_masters(dofs.relevant));
    DoFTools::make_hanging_node_constraints(dofs.dof_handler, lines);
    dofs.periodic_nodes.add_lines(lines);
    return lines;
  }



  template <int dim>
  double
  ProblemConstraints<dim>::largest_inhomogeneity(
    const Constraints &lines,
    const LA::Vector  &displacement) const
  {
    double largest = 0.;
    for (const auto i : dofs.owned)
      if (lines.is_inhomogeneously_constrained(i))
        largest = std::max(largest, std::abs(lines.get_inhomogeneity(i)));
    largest = Utilities::MPI::max(largest, communicator);
    // what is left of a fully applied displacement is roundoff
    return largest <= 1e-14 * displacement.linfty_norm() ? 0. : largest;
  }



  template <int dim>
  double
  ProblemConstraints<dim>::unapplied_displacement_of(
    const double      time,
    const LA::Vector &displacement) const
  {
    Constraints lines     = geometric_lines_seen();
    auto        couplings = rigid_couplings; // of this state
    for (auto &coupling : couplings)
      if (coupling.is_active(time))
        coupling.update(time, displacement, false);
    add_displacement_lines(time, displacement, couplings, lines);
    lines.close();
    return largest_inhomogeneity(lines, displacement);
  }



  template <int dim>
  void
  ProblemConstraints<dim>::place_rigid_bodies(const double time,
                                              LA::Vector  &displacement) const
  {
    Constraints lines(dofs.relevant);
    boundary_conditions.add_prescribed_displacements(dofs.mapping,
                                                     dofs.dof_handler,
                                                     dofs.periodic_nodes,
                                                     time,
                                                     displacement,
                                                     lines);
    lines.close();
    // Not +=: a rank that adds to a vector of which values have been set
    // communicates, and a rank without rigid bodies does not.
    for (const auto i : rigid_dofs)
      if (lines.is_inhomogeneously_constrained(i))
        displacement(i) = displacement(i) + lines.get_inhomogeneity(i);
    displacement.compress(VectorOperation::insert);
    make_rigid(time, displacement);
    for (const auto &coupling : rigid_couplings)
      if (boundary_conditions.drives_rigid_body(coupling.condition().body))
        coupling.place(time, displacement);
  }



  template <int dim>
  void
  ProblemConstraints<dim>::make_rigid(const double time,
                                      LA::Vector  &displacement) const
  {
    for (const auto &coupling : rigid_couplings)
      if (coupling.is_active(time))
        coupling.make_rigid(displacement);
  }



  template <int dim>
  void
  ProblemConstraints<dim>::make_conforming(LA::Vector &displacement) const
  {
    Constraints lines = geometric_lines_seen();
    lines.close();
    lines.distribute(displacement);
  }



  template <int dim>
  LA::Vector
  ProblemConstraints<dim>::driving_forces(const double time,
                                          const bool   with_springs) const
  {
    LA::Vector driving_forces(dofs.owned, communicator);
    for (const auto &coupling : rigid_couplings)
      if (coupling.is_active(time))
        coupling.add_driving_forces(time, with_springs, driving_forces);
    for (const auto &cut : cuts)
      cut.add_driving_forces(time, driving_forces);
    driving_forces.compress(VectorOperation::add);
    return driving_forces;
  }



  template <int dim>
  void
  ProblemConstraints<dim>::add_driving_terms(const double           time,
                                             const LA::Vector      &unbalanced,
                                             LA::BlockSparseMatrix &matrix,
                                             LA::BlockVector       &rhs) const
  {
    for (const auto &coupling : rigid_couplings)
      if (coupling.is_active(time))
        {
          coupling.add_tangent(time, unbalanced, matrix.block(0, 0));
          coupling.add_driving_forces(time, true, rhs.block(0));
        }
    for (const auto &cut : cuts)
      cut.add_driving_forces(time, rhs.block(0));
  }



  template <int dim>
  std::vector<std::pair<std::string, RigidReaction<dim>>>
  ProblemConstraints<dim>::reference_points(const double      time,
                                            const LA::Vector &displacement,
                                            const LA::Vector &unbalanced) const
  {
    std::vector<std::pair<std::string, RigidReaction<dim>>> result;
    for (const auto &coupling : rigid_couplings)
      result.emplace_back(coupling.condition().name,
                          coupling.reaction(time, displacement, unbalanced));
    return result;
  }



  template <int dim>
  std::vector<std::pair<std::string, CutReaction>>
  ProblemConstraints<dim>::cut_reactions(const LA::Vector &displacement,
                                         const LA::Vector &unbalanced) const
  {
    std::vector<std::pair<std::string, CutReaction>> result;
    for (const auto &cut : cuts)
      result.emplace_back(cut.name(), cut.reaction(displacement, unbalanced));
    return result;
  }



  template <int dim>
  void
  ProblemConstraints<dim>::update(const double      time,
                                  const LA::Vector &displacement,
                                  const bool        is_accepted)
  {
    if (is_up_to_date)
      return;
    bool rigidity_changes = false;
    for (auto &coupling : rigid_couplings)
      if (coupling.is_active(time))
        {
          rigidity_changes = true;
          if (coupling.update(time, displacement, is_accepted))
            masters_are_new = true;
        }
    const auto    &multipliers = contact.multipliers();
    const IndexSet needed      = with_masters(contact.needed_displacements());

    Constraints    displacement_lines = geometric_lines_seen();
    const IndexSet local =
      combined_index_set(needed, multipliers.locally_relevant());
    geometric_lines.reinit(local);
    copy_lines(known_where_needed(displacement_lines), geometric_lines);

    add_displacement_lines(time,
                           displacement,
                           rigid_couplings,
                           displacement_lines);
    increment_lines.reinit(local);
    copy_lines(known_where_needed(displacement_lines), increment_lines);
    multiplier_constraints.add_to(increment_lines,
                                  geometric_lines,
                                  dofs.owned.size());
    increment_lines.close();

    // the rows of hanging multipliers are a part of others, too
    Constraints multiplier_lines(local);
    multiplier_constraints.add_to(multiplier_lines,
                                  geometric_lines,
                                  dofs.owned.size());
    for (const auto &line : multiplier_lines.get_lines())
      if (!line.entries.empty()) // without any lines deal.II adds faster
        {
          geometric_lines.add_line(line.index);
          geometric_lines.add_entries(line.index, line.entries);
        }
    geometric_lines.close();

    unapplied = largest_inhomogeneity(increment_lines, displacement);
    // Newton may yet go back behind a state that it has not accepted.
    is_up_to_date = is_accepted && unapplied == 0. && !rigidity_changes;
  }

  template class ProblemConstraints<2>;
  template class ProblemConstraints<3>;
} // namespace stickslip
