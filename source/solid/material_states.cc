#include <stickslip/solid/material_states.h>

namespace stickslip
{
  template <int dim>
  MaterialStates<dim>::MaterialStates(
    const hp::MappingCollection<dim>                          &mapping,
    const DoFHandler<dim>                                     &dof_handler,
    const Bodies                                              &bodies,
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
    const std::vector<std::optional<MeanDilatation<dim>>>     &mean_dilatation,
    const PointHistory                                        &history)
    : bodies(bodies)
    , laws(laws)
    , mean_dilatation(mean_dilatation)
    , history(history)
    , history_fields(laws, dim)
    , scratch(make_cell_scratch(mapping, dof_handler, bodies.cross_section))
  {}



  template <int dim>
  void
  MaterialStates<dim>::evaluate(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const LA::Vector                                     &u,
    std::vector<MaterialState<dim>>                      &states)
  {
    states.clear();
    const types::material_id material = cell->material_id();
    if (bodies.bodies[bodies.body_of(material)].is_rigid)
      return;
    CellScratch<dim> &at = scratch[cell];
    at.reinit(cell, u);
    if (!at.deformation.compute(at.fe_values,
                                mean_dilatation[material],
                                at.element))
      return;
    for (unsigned int q = 0; q < at.n_points(); ++q)
      states.push_back(state_at(at, q, cell->active_cell_index(), material));
  }



  template <int dim>
  MaterialState<dim>
  MaterialStates<dim>::state_at(const CellScratch<dim>  &at,
                                const unsigned int       q,
                                const unsigned int       cell_index,
                                const types::material_id material) const
  {
    const ConstitutiveLaw  &law = *laws[material];
    std::vector<double>     new_history(law.n_history_variables());
    const ArrayView<double> new_variables(new_history.data(),
                                          new_history.size());

    MaterialState<dim> state;
    state.reference_position = at.fe_values.quadrature_point(q);
    state.JxW                = at.element.measure(at.fe_values, q);
    state.history.resize(history_fields.names().size());
    Tensor<2, 3> P;
    if (law.evaluate(at.deformation.for_law(q),
                     history.accepted(cell_index, q),
                     new_variables,
                     P,
                     nullptr))
      {
        const Tensor<2, 3> F =
          law.full_deformation_gradient(at.deformation.for_law(q),
                                        new_variables);
        state.cauchy_stress  = law.cauchy_stress(F, P);
        state.strain         = law.strain(F);
        state.nominal_stress = at.deformation.nominal_stress(q, P);
        state.history        = history_fields.values(material, new_variables);
      }
    return state;
  }



  template class MaterialStates<2>;
  template class MaterialStates<3>;
} // namespace stickslip
