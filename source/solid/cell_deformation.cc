#include <stickslip/solid/cell_deformation.h>

namespace stickslip
{
  template <int dim>
  CellDeformation<dim>::CellDeformation(const unsigned int n_points)
    : F(n_points)
    , seen(n_points)
  {}



  template <int dim>
  bool
  CellDeformation<dim>::compute(
    const FEValuesBase<dim>                  &fe_values,
    const std::optional<MeanDilatation<dim>> &mean_dilatation,
    ElementArrays<dim>                       &element)
  {
    rule = mean_dilatation;
    for (unsigned int q = 0; q < F.size(); ++q)
      {
        element.set_gradients(fe_values, q);
        F[q] = element.deformation_gradient();
      }
    if (!rule)
      {
        seen.swap(F);
        return true;
      }

    double volume = 0., sum = 0.;
    for (failed = 0; failed < F.size(); ++failed)
      {
        if (!rule->has_volume(F[failed]))
          return false;
        const double of_point = element.measure(fe_values, failed);
        volume += of_point;
        sum += rule->dilatation(F[failed]) * of_point;
      }
    mean = sum / volume;

    // the nodal derivative of theta_mean, or of ln J_mean
    const double scale = 1. / (rule->small_strains ? volume : sum);
    element.clear_mean_dilatation();
    for (unsigned int q = 0; q < F.size(); ++q)
      {
        element.set_gradients(fe_values, q);
        element.add_to_mean_dilatation(rule->derivative(F[q]),
                                       scale * element.measure(fe_values, q));
        seen[q] = rule->modified(F[q], mean);
      }
    return true;
  }



  template <int dim>
  void
  CellDeformation<dim>::add_response(const FEValuesBase<dim> &fe_values,
                                     const unsigned int       q,
                                     const Tensor<2, 3>      &P,
                                     const Tensor<4, 3>      *dP_dF,
                                     ElementArrays<dim>      &element) const
  {
    const double JxW = element.measure(fe_values, q);
    element.set_gradients(fe_values, q);
    if (!rule)
      {
        element.add_stress(P, JxW);
        if (dP_dF != nullptr)
          element.add_stress_tangent(*dP_dF, JxW);
        return;
      }
    const auto response = rule->response(F[q], mean, P, dP_dF);
    element.add_stress(response.P, JxW);
    element.add_mean_pressure(response.p, JxW);
    if (dP_dF != nullptr)
      {
        element.add_stress_tangent(response.A, JxW);
        element.add_mean_dilatation_response(response.column,
                                             response.row,
                                             response.square,
                                             JxW);
      }
  }



  template <int dim>
  void
  CellDeformation<dim>::finish_tangent(ElementArrays<dim> &element) const
  {
    if (rule)
      element.add_mean_dilatation_tangent();
  }



  template class CellDeformation<2>;
  template class CellDeformation<3>;
} // namespace stickslip
