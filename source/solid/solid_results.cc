// What the assembler of the solids says about a state, beside its equations.
#include <stickslip/solid/solid_assembler.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace stickslip
{
  template <int dim>
  void
  SolidAssembler<dim>::evaluate_point_states(const CellIterator      &cell,
                                             const LA::Vector        &u,
                                             std::vector<PointState> &states)
  {
    states.clear();
    if (is_rigid(cell))
      return;
    begin_cell(cell, u);

    if (!deformation.compute(fe_values,
                             mean_dilatation[cell->material_id()],
                             element))
      return;

    const ConstitutiveLaw &law = *laws[cell->material_id()];
    std::vector<double>    new_history(law.n_history_variables());
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Tensor<2, 3> &F = deformation.for_law(q);
        PointState          state;
        state.reference_position = fe_values.quadrature_point(q);
        state.JxW                = fe_values.JxW(q);
        state.history.resize(history_fields.names().size());

        const ArrayView<double> new_variables(new_history.data(),
                                              new_history.size());
        Tensor<2, 3>            P;
        if (law.evaluate(F,
                         history.accepted(cell->active_cell_index(), q),
                         new_variables,
                         P,
                         nullptr))
          {
            const Tensor<2, 3> F_full =
              law.full_deformation_gradient(F, new_variables);
            state.cauchy_stress = law.cauchy_stress(F_full, P);
            state.strain        = law.strain(F_full);
            state.history =
              history_fields.values(cell->material_id(), new_variables);
          }
        states.push_back(state);
      }
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
          cell->get_dof_indices(dof_indices);
          element.reinit(u, dof_indices);
          fe_values.reinit(
            typename Triangulation<dim>::active_cell_iterator(cell));
          work += viscous.work(fe_values,
                               dof_indices,
                               longitudinal_modulus(cell->material_id()),
                               element);
        }
    return Utilities::MPI::sum(work, dof_handler.get_communicator());
  }

#define INSTANTIATE(dim)                                    \
  template void SolidAssembler<dim>::evaluate_point_states( \
    const SolidAssembler<dim>::CellIterator &,              \
    const LA::Vector &,                                     \
    std::vector<SolidAssembler<dim>::PointState> &);        \
  template double SolidAssembler<dim>::stabilization_work(const LA::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
