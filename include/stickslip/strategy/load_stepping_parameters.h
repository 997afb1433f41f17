#ifndef stickslip_strategy_load_stepping_parameters_h
#define stickslip_strategy_load_stepping_parameters_h

#include <stickslip/base/choice.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /// Where Newton starts in a step.
  enum class Predictor
  {
    linear, ///< the displacements go on as in the last step
    none    ///< the accepted state
  };

  const Choices<Predictor> &
  all_predictors();



  /// The section "Load stepping".
  struct LoadSteppingParameters
  {
    double              end_time        = 1.;
    double              initial_step    = 1.;
    double              minimum_step    = 0.;
    double              maximum_step    = 0.;
    double              cut_factor      = 0.5;
    double              growth_factor   = 1.5;
    unsigned int        easy_iterations = 12;
    Predictor           predictor       = Predictor::linear;
    std::vector<double> requested_times;
    double              stabilization_factor     = 0.;
    bool                leaps_over_snaps         = true;
    bool                locates_contact_changes  = false;
    double              contact_change_tolerance = 1e-3; ///< of initial_step

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// Steps have to end at those of @p times that lie between 0 and the end.
    void
    request(const std::vector<double> &times);
  };
} // namespace stickslip

#endif
