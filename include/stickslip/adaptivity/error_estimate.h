#ifndef stickslip_adaptivity_error_estimate_h
#define stickslip_adaptivity_error_estimate_h

#include <stickslip/adaptivity/error_estimator.h>

namespace stickslip
{
  /// What an estimator says about a state.
  struct ErrorEstimate
  {
    Vector<double> indicators; ///< ErrorEstimator::indicators()
    bool           is_rule = false;
    /// Square root of their sum over all cells [energy^1/2]; 0 for a rule.
    double error = 0.;
    /// (int sigma : C^-1 : sigma)^1/2 of the state, over all bodies. Of Cauchy
    /// stresses, over the undeformed volume.
    double energy_norm = 0.;
    double n_selected  = 0.; ///< cells, by a rule, over all ranks

    /// 0 if there is neither error nor stress, infinity for an error without
    /// stress.
    double
    relative() const;

    /// False for an error where nothing is strained.
    bool
    says_something() const
    {
      return is_rule || energy_norm > 0.;
    }

    /// Whether something is strained, or a rule selects cells.
    bool
    marks_something() const
    {
      return is_rule ? n_selected > 0. : energy_norm > 0.;
    }
  };

  /// The estimate with these @p indicators of the cells of this rank.
  /// Collective.
  ErrorEstimate
  estimate_of(const Vector<double> &indicators,
              const bool            is_rule,
              const double          energy_norm,
              const MPI_Comm       &communicator);

  /// See ErrorEstimator::indicators(). Indicators and energy norm are 0 where
  /// bodies have moved and nothing else. Collective.
  template <int dim>
  ErrorEstimate
  estimate_error(const ErrorEstimator<dim> &estimator,
                 ContactProblem<dim>       &problem,
                 const LA::BlockVector     &x);
} // namespace stickslip

#endif
