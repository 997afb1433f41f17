#include <stickslip/adaptivity/error_estimator.h>

#include <stickslip/adaptivity/contact_zone.h>
#include <stickslip/adaptivity/kelly_estimator.h>
#include <stickslip/adaptivity/recovery_estimator.h>
#include <stickslip/adaptivity/residual_estimator.h>

#include <stickslip/base/registry.h>

namespace stickslip
{
  namespace
  {
    template <int dim>
    using EstimatorRegistry =
      Registry<ErrorEstimator<dim>, const AdaptationParameters &>;



    template <int dim>
    const EstimatorRegistry<dim> &
    error_estimators()
    {
      static const EstimatorRegistry<dim> registry(
        "error estimator",
        {{"residual",
          "what the stresses lack of equilibrium, inside of cells, between "
          "them, with loads, and with the tractions of contact on both "
          "surfaces; what is left of the contact law between its points",
          [](const AdaptationParameters &) {
            return std::make_unique<ResidualEstimator<dim>>();
          }},
         {"recovery",
          "smoothed stresses minus computed ones (Zienkiewicz and Zhu); the "
          "estimate that is nearest to the error where the solution is "
          "smooth; knows neither loads nor contact",
          [](const AdaptationParameters &) {
            return std::make_unique<RecoveryEstimator<dim>>();
          }},
         {"Kelly",
          "jumps of the normal derivatives of the displacements between the "
          "cells of a body (deal.II's KellyErrorEstimator); knows neither "
          "loads nor contact, and sees errors where materials meet",
          [](const AdaptationParameters &) {
            return std::make_unique<KellyEstimator<dim>>();
          }},
         {"contact zone",
          "no error, but the cells on both sides with a face in contact or "
          "with a gap smaller than Distance",
          [](const AdaptationParameters &parameters) {
            return std::make_unique<ContactZone<dim>>(parameters.distance);
          }},
         {"contact edge",
          "no error, but the cells on both sides with a contact face within "
          "Distance of where contact ends, or sticking begins",
          [](const AdaptationParameters &parameters) {
            return std::make_unique<ContactEdge<dim>>(parameters.distance);
          }}});
      return registry;
    }
  } // namespace



  template <int dim>
  std::unique_ptr<ErrorEstimator<dim>>
  create_error_estimator(const AdaptationParameters &parameters)
  {
    return error_estimators<dim>().create(parameters.estimator,
                                          "Adaptation/Estimator",
                                          parameters);
  }



  std::string
  error_estimator_selection()
  {
    return "none|" + error_estimators<2>().selection();
  }



  std::string
  error_estimator_descriptions()
  {
    return "none: nobody asks; " + error_estimators<2>().descriptions();
  }

  template std::unique_ptr<ErrorEstimator<2>>
  create_error_estimator(const AdaptationParameters &);
  template std::unique_ptr<ErrorEstimator<3>>
  create_error_estimator(const AdaptationParameters &);
} // namespace stickslip
