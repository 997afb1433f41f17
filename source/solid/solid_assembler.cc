#include <stickslip/solid/solid_assembler.h>

#include <stickslip/base/user_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  template <int dim>
  SolidAssembler<dim>::SolidAssembler(
    const hp::MappingCollection<dim>                          &mapping,
    const DoFHandler<dim>                                     &dof_handler,
    const Bodies                                              &bodies,
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
    const BoundaryConditions<dim> &boundary_conditions,
    const std::vector<bool>       &with_mean_dilatation)
    : dof_handler(dof_handler)
    , bodies(bodies)
    , laws(laws)
    , mean_dilatation(laws.size())
    , material_states(mapping,
                      dof_handler,
                      bodies,
                      this->laws,
                      mean_dilatation,
                      history)
    , surface_loads(mapping, dof_handler, boundary_conditions.loads())
    , viscous(dof_handler)
    , largest_modulus(0.)
    , scratch(make_cell_scratch(mapping, dof_handler, bodies.cross_section))
    , body_forces(bodies.bodies.size())
  {
    AssertDimension(laws.size(), bodies.regions.size());
    for (unsigned int r = 0; r < laws.size(); ++r)
      {
        const Body &body = bodies.bodies[bodies.regions[r].body];
        if (!laws[r] && !body.is_rigid)
          throw UserError("Bodies/" + body.name +
                          "/Material is empty, but the body is not rigid.");
        if (laws[r])
          largest_modulus =
            std::max(largest_modulus, laws[r]->longitudinal_modulus());
        if (laws[r] && !with_mean_dilatation.empty() && with_mean_dilatation[r])
          mean_dilatation[r].emplace(laws[r]->is_geometrically_linear(),
                                     bodies.cross_section.is_axisymmetric
                                       ? 3
                                       : dim);
      }
    for (const Load<dim> &load : boundary_conditions.loads())
      if (load.type == BoundaryConditionType::body_force)
        body_forces[load.body].push_back(&load);
    boundary_conditions.measure_distributed_forces(mapping, dof_handler);
    initialize_history();
  }



  template <int dim>
  void
  SolidAssembler<dim>::initialize_history()
  {
    const unsigned int n_cells =
      dof_handler.get_triangulation().n_active_cells();
    std::vector<unsigned int> n_variables(n_cells, 0), n_points(n_cells, 0);
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && !is_rigid(cell))
        {
          n_variables[cell->active_cell_index()] =
            laws[cell->material_id()]->n_history_variables();
          n_points[cell->active_cell_index()] = scratch[cell].n_points();
        }
    history.reinit(n_variables, n_points);

    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (n_variables[cell->active_cell_index()] > 0)
        for (unsigned int q = 0; q < n_points[cell->active_cell_index()]; ++q)
          laws[cell->material_id()]->initialize_history(
            history.trial(cell->active_cell_index(), q));
    history.accept();
  }



  template <int dim>
  bool
  SolidAssembler<dim>::is_rigid(const CellIterator &cell) const
  {
    return bodies.bodies[bodies.body_of(cell->material_id())].is_rigid;
  }



  template <int dim>
  bool
  SolidAssembler<dim>::is_linear(const CellIterator &cell) const
  {
    return !is_rigid(cell) && laws[cell->material_id()]->is_linear();
  }



  template <int dim>
  bool
  SolidAssembler<dim>::has_loads(const CellIterator &cell) const
  {
    return !body_forces[bodies.body_of(cell->material_id())].empty() ||
           surface_loads.act_on(cell);
  }



  template <int dim>
  void
  SolidAssembler<dim>::assemble_linear_stiffness(const LA::Vector &u)
  {
    if (linear_stiffness_is_known)
      return;
    std::vector<CellIterator> cells;
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && is_linear(cell))
        cells.push_back(cell);
    const auto stiffness_of = [&](const CellIterator &cell, auto &result) {
      CellScratch<dim> &at = scratch[cell];
      at.reinit(cell, u);
      add_stresses(cell, true, at);
      at.element.copy_stiffness(result);
    };
    linear_stiffness.assemble(dof_handler.get_fe_collection(),
                              cells,
                              stiffness_of);
    linear_stiffness_is_known = true;
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_residual(const LA::Vector  &u,
                                    const double       time,
                                    const Constraints &geometric,
                                    LA::Vector        &internal,
                                    LA::Vector        &external)
  {
    assemble_linear_stiffness(u);
    failure = InadmissiblePoint<dim>();
    linear_stiffness.add_forces(u, geometric, internal);
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && !is_rigid(cell) && !is_only_linear(cell))
        {
          const CellScratch<dim> &at = evaluate_cell(cell, u, time, false);
          geometric.distribute_local_to_global(at.element.internal,
                                               at.dof_indices,
                                               internal);
          geometric.distribute_local_to_global(at.element.external,
                                               at.dof_indices,
                                               external);
        }
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_tangent(const LA::Vector  &u,
                                   const double       time,
                                   const Constraints &constraints,
                                   LA::SparseMatrix  &matrix,
                                   LA::Vector        &rhs)
  {
    assemble_linear_stiffness(u);
    failure = InadmissiblePoint<dim>();
    linear_stiffness.add_tangent(u, constraints, matrix, rhs);
    FullMatrix<double> stiffness;
    Vector<double>     minus_residual;
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && !is_only_linear(cell))
        {
          if (is_rigid(cell))
            {
              add_rigid_cell(cell, constraints, matrix);
              continue;
            }
          const CellScratch<dim> &at = evaluate_cell(cell, u, time, true);
          stiffness.reinit(at.dof_indices.size(), at.dof_indices.size(), true);
          at.element.copy_stiffness(stiffness);
          minus_residual = at.element.external;
          minus_residual -= at.element.internal;
          constraints.distribute_local_to_global(
            stiffness, minus_residual, at.dof_indices, matrix, rhs);
        }
  }



  template <int dim>
  const CellScratch<dim> &
  SolidAssembler<dim>::evaluate_cell(const CellIterator &cell,
                                     const LA::Vector   &u,
                                     const double        time,
                                     const bool          with_tangent)
  {
    CellScratch<dim> &at = scratch[cell];
    at.reinit(cell, u);
    if (!is_linear(cell))
      add_stresses(cell, with_tangent, at);
    add_body_forces(cell, time, at);
    surface_loads.add_cell(cell, time, with_tangent, at.element);
    if (viscous.is_active())
      viscous.add_cell(cell,
                       longitudinal_modulus(cell->material_id()),
                       with_tangent,
                       at);
    return at;
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_stresses(const CellIterator &cell,
                                    const bool          with_tangent,
                                    CellScratch<dim>   &at)
  {
    if (!at.deformation.compute(at.fe_values,
                                mean_dilatation[cell->material_id()],
                                at.element))
      {
        record_failure(cell, at, at.deformation.failed_point(), false);
        return;
      }
    const ConstitutiveLaw &law        = *laws[cell->material_id()];
    const unsigned int     cell_index = cell->active_cell_index();
    Tensor<2, 3>           P;
    Tensor<4, 3>           dP_dF;
    Tensor<4, 3>          *tangent = with_tangent ? &dP_dF : nullptr;
    for (unsigned int q = 0; q < at.n_points(); ++q)
      {
        const Tensor<2, 3> &F = at.deformation.for_law(q);
        const bool          has_volume =
          law.is_geometrically_linear() || determinant(F) > 0.;
        if (!has_volume ||
            !law.evaluate(F,
                          history.accepted(cell_index, q),
                          history.trial(cell_index, q),
                          P,
                          tangent) ||
            !std::isfinite(P.norm_square()))
          {
            record_failure(cell, at, q, has_volume);
            continue;
          }
        at.deformation.add_response(at.fe_values, q, P, tangent, at.element);
      }
    if (with_tangent)
      at.deformation.finish_tangent(at.element);
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_body_forces(const CellIterator &cell,
                                       const double        time,
                                       CellScratch<dim>   &at)
  {
    for (const Load<dim> *load :
         body_forces[bodies.body_of(cell->material_id())])
      for (unsigned int q = 0; q < at.n_points(); ++q)
        at.element.add_load(at.fe_values,
                            q,
                            load->vector(at.fe_values.quadrature_point(q),
                                         time),
                            at.element.external);
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_rigid_cell(const CellIterator &cell,
                                      const Constraints  &constraints,
                                      LA::SparseMatrix   &matrix)
  {
    // All displacements are prescribed, or depend on the few that stand for
    // the motion of the body; the matrix needs a diagonal of the size of its
    // neighbours: modulus x length^(dim - 2), all around.
    std::vector<types::global_dof_index> dof_indices(
      cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dof_indices);
    const double modulus = largest_modulus > 0. ? largest_modulus : 1.;
    const double entry   = modulus * std::pow(cell->diameter(), dim - 2) *
                         bodies.cross_section.circumference(cell->center());
    for (const auto i : dof_indices)
      if (constraints.is_constrained(i))
        matrix.add(i, i, entry);
  }



  template <int dim>
  void
  SolidAssembler<dim>::record_failure(const CellIterator     &cell,
                                      const CellScratch<dim> &at,
                                      const unsigned int      q,
                                      const bool              has_volume)
  {
    failure.record(at.fe_values.quadrature_point(q),
                   bodies.body_of(cell->material_id()),
                   has_volume);
  }



  template <int dim>
  bool
  SolidAssembler<dim>::state_is_admissible() const
  {
    return !failure.exists(dof_handler.get_communicator());
  }



  template <int dim>
  InadmissibleState
  SolidAssembler<dim>::inadmissible_state() const
  {
    return failure.describe(dof_handler.get_communicator(), bodies);
  }



  template <int dim>
  void
  SolidAssembler<dim>::accept()
  {
    history.accept();
  }



  template <int dim>
  void
  SolidAssembler<dim>::restore()
  {
    history.restore();
  }



  template <int dim>
  double
  SolidAssembler<dim>::longitudinal_modulus(
    const types::material_id material) const
  {
    return laws[material] ? laws[material]->longitudinal_modulus() : 0.;
  }



  template <int dim>
  double
  SolidAssembler<dim>::stabilization_work(const LA::Vector &u)
  {
    if (!viscous.is_active())
      return 0.;
    double work = 0.;
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && !is_rigid(cell))
        {
          CellScratch<dim> &at = scratch[cell];
          at.reinit(cell, u);
          work +=
            viscous.work(cell, longitudinal_modulus(cell->material_id()), at);
        }
    return Utilities::MPI::sum(work, dof_handler.get_communicator());
  }



  template class SolidAssembler<2>;
  template class SolidAssembler<3>;
} // namespace stickslip
