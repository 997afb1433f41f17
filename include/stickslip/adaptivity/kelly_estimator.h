#ifndef stickslip_adaptivity_kelly_estimator_h
#define stickslip_adaptivity_kelly_estimator_h

#include <stickslip/adaptivity/error_estimator.h>

namespace stickslip
{
  /**
   * Jumps of the normal derivatives of the displacements over the faces of a
   * cell (Kelly, Gago, Zienkiewicz, Babuska, IJNME 19, 1983):
   *
   *   eta_K^2 = 2 mu_K h_K / 24 sum_F int_F |[du/dN]|^2,
   *
   * by deal.II, hanging nodes included. What it knows of the state is the
   * displacements of each body alone: boundary faces have no jumps, so that
   * contact is seen through the strains that it makes. Where materials meet,
   * jumps are taken for errors.
   */
  template <int dim>
  class KellyEstimator : public ErrorEstimator<dim>
  {
  public:
    Vector<double>
    indicators(ContactProblem<dim>   &problem,
               const LA::BlockVector &x) const override;
  };
} // namespace stickslip

#endif
