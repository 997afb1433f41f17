#ifndef stickslip_adaptivity_error_estimator_h
#define stickslip_adaptivity_error_estimator_h

#include <stickslip/adaptivity/adaptation_parameters.h>

#include <stickslip/base/types.h>

#include <stickslip/problem/contact_problem.h>

#include <deal.II/lac/vector.h>

#include <memory>
#include <string>

namespace stickslip
{
  /**
   * Says for each cell how much of the error of a state it has, or by another
   * rule which cells should be fine.
   */
  template <int dim>
  class ErrorEstimator
  {
  public:
    virtual ~ErrorEstimator() = default;

    /**
     * Squares of the indicators of the active cells of this rank, by
     * active_cell_index, zero elsewhere and on rigid bodies. They are energies
     * [stress x length^dim, 2D: per thickness], and their sum over all ranks
     * is the square of the estimated error in the energy norm
     * (e, e) = int e : C : e, C the modulus of the undeformed material.
     * A rule (is_rule()) has ones instead, on cells of rigid bodies, too.
     *
     * @p x is a state that has been accepted and that @p problem has
     * evaluated last (ContactProblem::accept_step()). Collective.
     */
    virtual Vector<double>
    indicators(ContactProblem<dim>   &problem,
               const LA::BlockVector &x) const = 0;

    /// True if it selects cells and does not know their errors.
    virtual bool
    is_rule() const
    {
      return false;
    }
  };



  /// The estimator that @p parameters name. Throws UserError for an unknown
  /// name, `none` among them.
  template <int dim>
  std::unique_ptr<ErrorEstimator<dim>>
  create_error_estimator(const AdaptationParameters &parameters);

  /// All names and `none`, for Patterns::Selection.
  std::string
  error_estimator_selection();

  /// What each of them is, for the documentation of the parameter.
  std::string
  error_estimator_descriptions();
} // namespace stickslip

#endif
