#include <stickslip/contact/point/contact_state.h>

#include <stickslip/contact/point/contact_element.h>

namespace stickslip
{
  template <int dim>
  ObservedState<dim>
  observe(const ContactPoint<dim>      &point,
          const ContactEvaluation<dim> &evaluation)
  {
    ObservedState<dim>   result;
    const Tensor<1, dim> Lambda =
      tangential_vector<dim>(evaluation.multipliers.Lambda,
                             evaluation.kinematics.tau);
    if (!point.pairing.paired)
      return result;
    result.values = {evaluation.multipliers.lambda_n,
                     evaluation.kinematics.d_n,
                     Lambda,
                     evaluation.kinematics.d_t};
    if (!evaluation.status.closed)
      result.state = ContactState::open;
    else if (evaluation.status.stick)
      result.state = ContactState::stick;
    else
      {
        result.state = ContactState::slip;
        const Tensor<1, dim> trial =
          Lambda +
          point.regularization.r_t_augmentation * evaluation.kinematics.d_t;
        const double length = trial.norm();
        if (evaluation.response.threshold > 0. && length > 0.)
          result.slip_direction = trial / length;
      }
    return result;
  }

  template ObservedState<2>
  observe(const ContactPoint<2> &, const ContactEvaluation<2> &);
  template ObservedState<3>
  observe(const ContactPoint<3> &, const ContactEvaluation<3> &);
} // namespace stickslip
