#include <stickslip/contact/assembly/point_evaluator.h>

#include <algorithm>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// Pressure up to which a point is closed; the gap behind it is roundoff,
    /// too, however small r_n is.
    template <int dim>
    double
    pressure_of_roundoff(const ContactPoint<dim> &point)
    {
      return point.scales.negligible_pressure *
             std::min(1.,
                      point.regularization.r_n_status / point.scales.stiffness);
    }



    template <int dim>
    ContactStatus
    status_of(const ContactPair<dim>       &pair,
              const ContactPoint<dim>      &point,
              const ContactEvaluation<dim> &state,
              const bool                    is_live,
              const bool                    is_rounded,
              const StatusRule              rule)
    {
      const bool    has_friction = pair.parameters.has_friction();
      ContactStatus result;
      if (!point.pairing.paired)
        return result;
      if (pair.parameters.is_bilateral())
        return {true, pair.parameters.is_tied()};
      if (rule == StatusRule::all_stick)
        return {true, has_friction};
      result.closed = point.treatment.fixed_closed.value_or(
        is_live ? is_closed(state.multipliers.lambda_n,
                            state.kinematics.d_n,
                            point.regularization,
                            pressure_of_roundoff(point))
                : point.frozen.closed);
      if ((result.closed || is_rounded) && has_friction)
        result.stick = point.treatment.fixed_stick.value_or(
          is_stick(tangential_vector<dim>(state.multipliers.Lambda,
                                          state.kinematics.tau),
                   state.kinematics.d_t,
                   point.regularization));
      return result;
    }



    ThresholdKind
    threshold_kind(const ContactPairParameters &parameters, const bool is_live)
    {
      if (!parameters.has_tangential_traction())
        return ThresholdKind::none;
      if (parameters.is_tied() || parameters.friction == Friction::Tresca ||
          !is_live)
        return ThresholdKind::given;
      return parameters.threshold_form == ThresholdForm::plain
               ? ThresholdKind::plain
               : ThresholdKind::augmented;
    }
  } // namespace



  template <int dim>
  ContactElement<dim>
  PointEvaluator<dim>::element_of(const ContactPair<dim>  &pair,
                                  const ContactPoint<dim> &point) const
  {
    const unsigned int  q = point.geometry.quadrature_index;
    ContactElement<dim> element{point,
                                pair.table.displacement[q].value,
                                pair.table.multiplier[q],
                                pair.n_multiplier_components()};
    if (point.pairing.paired)
      {
        element.master = &pair.patch->face(point.pairing.face);
        element.master_configuration =
          &pair.patch->configuration(point.pairing.face);
      }
    return element;
  }



  template <int dim>
  MortarElement<dim>
  PointEvaluator<dim>::mortar_element_of(const ContactPair<dim>  &pair,
                                         const ContactPoint<dim> &point) const
  {
    const unsigned int i = point.geometry.mortar_node;
    return {point,
            pair.mortar->node(i),
            pair.mortar->average(i),
            pair.mortar->frame(i),
            point.geometry.quadrature_index,
            pair.n_multiplier_components()};
  }



  template <int dim>
  Multipliers<dim>
  PointEvaluator<dim>::multipliers_at(const ContactPair<dim>  &pair,
                                      const ContactPoint<dim> &point,
                                      const LA::Vector        &values) const
  {
    std::vector<double> nodal_values;
    for (const auto dof :
         pair.slave_faces[point.geometry.slave_face].multiplier_dofs)
      nodal_values.push_back(values(dof));
    return interpolate_multipliers(element_of(pair, point), nodal_values);
  }



  template <int dim>
  double
  PointEvaluator<dim>::lambda_n_at_node(const ContactPair<dim> &pair,
                                        const unsigned int      slave_face,
                                        const unsigned int      j) const
  {
    std::vector<double> L;
    pair.multiplier_shape.evaluate_values(pair.displacement_shape.node(j), L);
    const auto        &dofs   = pair.slave_faces[slave_face].multiplier_dofs;
    const unsigned int n_comp = pair.n_multiplier_components();
    double             value  = 0.;
    for (unsigned int l = 0; l < L.size(); ++l)
      value += L[l] * lambda(dofs[l * n_comp]);
    return value;
  }



  template <int dim>
  void
  PointEvaluator<dim>::evaluate_kinematics(const ContactPair<dim>  &pair,
                                           const ContactPoint<dim> &point,
                                           const bool linearize_geometry,
                                           const bool with_derivatives)
  {
    state.multipliers = multipliers_at(pair, point, lambda);
    if (!point.pairing.paired)
      {
        state.kinematics = ContactKinematics<dim>();
        return;
      }
    if (pair.mortar)
      {
        evaluate_mortar_kinematics(mortar_element_of(pair, point),
                                   pair.mortar->direction(
                                     point.geometry.mortar_node),
                                   live.geometry && linearize_geometry,
                                   with_derivatives,
                                   state.kinematics);
        return;
      }
    const unsigned int f = point.pairing.face;
    pair.patch->evaluate(point.pairing,
                         pair.patch->configuration(f),
                         state.master);
    pair.patch->evaluate(point.pairing,
                         pair.patch->old_configuration(f),
                         old_master);
    evaluate_contact_kinematics(point.pairing,
                                state.master,
                                old_master,
                                pair.slave_position(point),
                                pair.has_smoothed_normals(),
                                live.geometry && linearize_geometry,
                                with_derivatives,
                                state.kinematics);
  }



  template <int dim>
  bool
  PointEvaluator<dim>::live_closed(const ContactPair<dim>  &pair,
                                   const ContactPoint<dim> &point)
  {
    if (pair.parameters.is_bilateral())
      return point.pairing.paired;
    evaluate_kinematics(pair, point, false, false);
    return point.pairing.paired && is_closed(state.multipliers.lambda_n,
                                             state.kinematics.d_n,
                                             point.regularization,
                                             pressure_of_roundoff(point));
  }



  template <int dim>
  double
  PointEvaluator<dim>::live_threshold(const ContactPair<dim>  &pair,
                                      const ContactPoint<dim> &point)
  {
    if (pair.parameters.friction != Friction::Coulomb || !point.pairing.paired)
      return 0.;
    evaluate_kinematics(pair, point, false, false);
    // A frozen status may still be wrong, and its gap r_n times too large.
    const bool counts_no_gap =
      !live.status && pair.parameters.is_independent_of_regularization();
    return augmented_threshold(pair.parameters.friction_coefficient,
                               state.multipliers.lambda_n,
                               counts_no_gap
                                 ? 0.
                                 : point.regularization.r_n_augmentation,
                               state.kinematics.d_n);
  }



  template <int dim>
  PointLaw
  PointEvaluator<dim>::law_at(const ContactPair<dim>  &pair,
                              const ContactPoint<dim> &point) const
  {
    const ContactPairParameters &parameters = pair.parameters;

    PointLaw law;
    law.r = point.regularization;
    // what is closed anyway needs no augmentation, and would only feel the
    // roundoff of its gap
    if (status_rule == StatusRule::all_stick || parameters.is_bilateral())
      law.r.r_n_augmentation = law.r.r_t_augmentation = 0.;
    law.threshold.kind = threshold_kind(parameters, live.threshold);
    law.threshold.negligible =
      parameters.friction_coefficient * point.scales.negligible_pressure;
    law.threshold.friction_coefficient = parameters.friction_coefficient;
    law.threshold.given                = parameters.friction == Friction::Tresca
                                           ? parameters.tresca_threshold
                                           : point.frozen.threshold;
    if (parameters.is_tied())
      law.threshold.given = pair.softest_modulus;
    law.open_row       = point.scales.open_row;
    law.holds_at_point = pair.mortar != nullptr;
    if (point.pairing.paired && live.status &&
        status_rule == StatusRule::contact_law && !parameters.is_bilateral() &&
        !point.treatment.fixed_closed)
      law.rounding = rounding;
    return law;
  }



  template <int dim>
  void
  PointEvaluator<dim>::evaluate_point(const ContactPair<dim>  &pair,
                                      const ContactPoint<dim> &point,
                                      const bool linearize_geometry,
                                      const bool with_derivatives)
  {
    evaluate_kinematics(pair, point, linearize_geometry, with_derivatives);
    const bool is_restrained =
      point.pairing.paired && !point.restrained.directions.empty();
    Tensor<2, dim> projector;
    if (is_restrained)
      projector = restrain_slip(point.restrained.directions,
                                with_derivatives,
                                state.kinematics);
    const PointLaw law = law_at(pair, point);
    state.status       = status_of(
      pair, point, state, live.status, law.rounding.acts(), status_rule);
    evaluate_contact_law(law,
                         state.kinematics,
                         state.multipliers,
                         state.status,
                         with_derivatives,
                         state.response);
    if (is_restrained)
      restrain_Lambda(state.kinematics,
                      state.multipliers,
                      projector,
                      point.restrained.Lambda,
                      law.r.r_t_law,
                      with_derivatives,
                      state.response);
  }



  template <int dim>
  const ContactEvaluation<dim> &
  PointEvaluator<dim>::evaluate(const ContactPair<dim>  &pair,
                                const ContactPoint<dim> &point)
  {
    evaluate_point(pair, point, false, false);
    return state;
  }



  template <int dim>
  ContactEvaluation<dim> &
  PointEvaluator<dim>::differentiate(const ContactPair<dim>  &pair,
                                     const ContactPoint<dim> &point,
                                     const bool linearize_geometry)
  {
    evaluate_point(pair, point, linearize_geometry, true);
    return state;
  }



  template class PointEvaluator<2>;
  template class PointEvaluator<3>;
} // namespace stickslip
