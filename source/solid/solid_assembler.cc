#include <stickslip/solid/solid_assembler.h>

#include <stickslip/base/user_error.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  template <int dim>
  SolidAssembler<dim>::SolidAssembler(
    const Mapping<dim>                                        &mapping,
    const DoFHandler<dim>                                     &dof_handler,
    const Bodies                                              &bodies,
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
    const BoundaryConditions<dim> &boundary_conditions,
    const std::vector<bool>       &with_mean_dilatation)
    : dof_handler(dof_handler)
    , bodies(bodies)
    , laws(laws)
    , mean_dilatation(laws.size())
    , quadrature(
        stickslip::cell_quadrature<dim>(dof_handler.get_fe().reference_cell(),
                                        dof_handler.get_fe().degree))
    , material_states(mapping,
                      dof_handler,
                      quadrature,
                      bodies,
                      this->laws,
                      mean_dilatation,
                      history)
    , surface_loads(mapping, dof_handler.get_fe(), boundary_conditions.loads())
    , viscous(dof_handler)
    , largest_modulus(0.)
    , fe_values(mapping,
                dof_handler.get_fe().base_element(0),
                quadrature,
                update_values | update_gradients | update_quadrature_points |
                  update_JxW_values)
    , element(dof_handler.get_fe(), bodies.cross_section)
    , deformation(quadrature.size())
    , stiffness(dof_handler.get_fe().n_dofs_per_cell(),
                dof_handler.get_fe().n_dofs_per_cell())
    , dof_indices(dof_handler.get_fe().n_dofs_per_cell())
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
    std::vector<unsigned int> n_variables(n_cells, 0);
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && !is_rigid(cell))
        n_variables[cell->active_cell_index()] =
          laws[cell->material_id()]->n_history_variables();
    history.reinit(n_variables, quadrature.size());

    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (n_variables[cell->active_cell_index()] > 0)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
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
      begin_cell(cell, u);
      add_stresses(cell, true);
      element.copy_stiffness(result);
    };
    linear_stiffness.assemble(dof_handler.get_fe(), cells, stiffness_of);
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
          evaluate_cell(cell, u, time, false);
          geometric.distribute_local_to_global(element.internal,
                                               dof_indices,
                                               internal);
          geometric.distribute_local_to_global(element.external,
                                               dof_indices,
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
    Vector<double> minus_residual(dof_indices.size());
    for (const CellIterator &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && !is_only_linear(cell))
        {
          if (is_rigid(cell))
            {
              add_rigid_cell(cell, constraints, matrix);
              continue;
            }
          evaluate_cell(cell, u, time, true);
          element.copy_stiffness(stiffness);
          minus_residual = element.external;
          minus_residual -= element.internal;
          constraints.distribute_local_to_global(
            stiffness, minus_residual, dof_indices, matrix, rhs);
        }
  }



  template <int dim>
  void
  SolidAssembler<dim>::begin_cell(const CellIterator &cell, const LA::Vector &u)
  {
    cell->get_dof_indices(dof_indices);
    element.reinit(u, dof_indices);
    fe_values.reinit(typename Triangulation<dim>::active_cell_iterator(cell));
  }



  template <int dim>
  void
  SolidAssembler<dim>::evaluate_cell(const CellIterator &cell,
                                     const LA::Vector   &u,
                                     const double        time,
                                     const bool          with_tangent)
  {
    begin_cell(cell, u);
    if (!is_linear(cell))
      add_stresses(cell, with_tangent);
    add_body_forces(cell, time);
    surface_loads.add_cell(cell, time, with_tangent, element);
    if (viscous.is_active())
      viscous.add_cell(fe_values,
                       dof_indices,
                       longitudinal_modulus(cell->material_id()),
                       with_tangent,
                       element);
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_stresses(const CellIterator &cell,
                                    const bool          with_tangent)
  {
    if (!deformation.compute(fe_values,
                             mean_dilatation[cell->material_id()],
                             element))
      {
        record_failure(cell, deformation.failed_point(), false);
        return;
      }
    const ConstitutiveLaw &law        = *laws[cell->material_id()];
    const unsigned int     cell_index = cell->active_cell_index();
    Tensor<2, 3>           P;
    Tensor<4, 3>           dP_dF;
    Tensor<4, 3>          *tangent = with_tangent ? &dP_dF : nullptr;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Tensor<2, 3> &F = deformation.for_law(q);
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
            record_failure(cell, q, has_volume);
            continue;
          }
        deformation.add_response(fe_values, q, P, tangent, element);
      }
    if (with_tangent)
      deformation.finish_tangent(element);
  }



  template <int dim>
  void
  SolidAssembler<dim>::add_body_forces(const CellIterator &cell,
                                       const double        time)
  {
    for (const Load<dim> *load :
         body_forces[bodies.body_of(cell->material_id())])
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        element.add_load(fe_values,
                         q,
                         load->vector(fe_values.quadrature_point(q), time),
                         element.external);
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
  SolidAssembler<dim>::record_failure(const CellIterator &cell,
                                      const unsigned int  q,
                                      const bool          has_volume)
  {
    failure.record(fe_values.quadrature_point(q),
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
          begin_cell(cell, u);
          work += viscous.work(fe_values,
                               dof_indices,
                               longitudinal_modulus(cell->material_id()),
                               element);
        }
    return Utilities::MPI::sum(work, dof_handler.get_communicator());
  }



  template class SolidAssembler<2>;
  template class SolidAssembler<3>;
} // namespace stickslip
