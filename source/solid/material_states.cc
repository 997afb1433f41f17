#include <stickslip/solid/material_states.h>

namespace stickslip
{
  template <int dim>
  MaterialStates<dim>::MaterialStates(
    const Mapping<dim>                                        &mapping,
    const DoFHandler<dim>                                     &dof_handler,
    const Quadrature<dim>                                     &quadrature,
    const Bodies                                              &bodies,
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
    const std::vector<std::optional<MeanDilatation<dim>>>     &mean_dilatation,
    const PointHistory                                        &history)
    : bodies(bodies)
    , laws(laws)
    , mean_dilatation(mean_dilatation)
    , history(history)
    , history_fields(laws, dim)
    , fe_values(mapping,
                dof_handler.get_fe().base_element(0),
                quadrature,
                update_values | update_gradients | update_quadrature_points |
                  update_JxW_values)
    , element(dof_handler.get_fe(), bodies.cross_section)
    , deformation(quadrature.size())
    , dof_indices(dof_handler.get_fe().n_dofs_per_cell())
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
    cell->get_dof_indices(dof_indices);
    element.reinit(u, dof_indices);
    fe_values.reinit(typename Triangulation<dim>::active_cell_iterator(cell));
    if (!deformation.compute(fe_values, mean_dilatation[material], element))
      return;
    for (const unsigned int q : fe_values.quadrature_point_indices())
      states.push_back(state_at(q, cell->active_cell_index(), material));
  }



  template <int dim>
  MaterialState<dim>
  MaterialStates<dim>::state_at(const unsigned int       q,
                                const unsigned int       cell_index,
                                const types::material_id material)
  {
    const ConstitutiveLaw  &law = *laws[material];
    std::vector<double>     new_history(law.n_history_variables());
    const ArrayView<double> new_variables(new_history.data(),
                                          new_history.size());

    MaterialState<dim> state;
    state.reference_position = fe_values.quadrature_point(q);
    state.JxW                = element.measure(fe_values, q);
    state.history.resize(history_fields.names().size());
    Tensor<2, 3> P;
    if (law.evaluate(deformation.for_law(q),
                     history.accepted(cell_index, q),
                     new_variables,
                     P,
                     nullptr))
      {
        const Tensor<2, 3> F =
          law.full_deformation_gradient(deformation.for_law(q), new_variables);
        state.cauchy_stress  = law.cauchy_stress(F, P);
        state.strain         = law.strain(F);
        state.nominal_stress = deformation.nominal_stress(q, P);
        state.history        = history_fields.values(material, new_variables);
      }
    return state;
  }



  template class MaterialStates<2>;
  template class MaterialStates<3>;
} // namespace stickslip
