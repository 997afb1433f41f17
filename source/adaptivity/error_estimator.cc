#include <stickslip/adaptivity/error_estimator.h>

#include <stickslip/adaptivity/kelly_estimator.h>

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
        {{"Kelly",
          "jumps of the normal derivatives of the displacements between the "
          "cells of a body (deal.II's KellyErrorEstimator); knows neither "
          "loads nor contact, and sees errors where materials meet",
          [](const AdaptationParameters &) {
            return std::make_unique<KellyEstimator<dim>>();
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
