#ifndef stickslip_adaptivity_recovery_estimator_h
#define stickslip_adaptivity_recovery_estimator_h

#include <stickslip/adaptivity/error_estimator.h>

namespace stickslip
{
  /**
   * Smoothed stresses minus those of the displacements (Zienkiewicz, Zhu,
   * IJNME 24, 1987 and 33, 1992):
   *
   *   eta_K^2 = int_K (s* - s) : C^-1 : (s* - s),
   *
   * s the Cauchy stress, over the undeformed cell, C the modulus of the
   * undeformed material.
   *
   * s* is a polynomial for each cell, of the degree p of the displacements: the
   * one nearest to s at the points of Gauss' rule with p points per direction,
   * of the cell and of those that share a vertex with it (patches around
   * elements: Wiberg, Abdulwahab, IJNME 36, 1993). There the stresses of
   * regular meshes are of a higher order, so that s* is, and eta over the error
   * tends to one. A patch does not reach over contact, nor to another material:
   * stresses jump there.
   */
  template <int dim>
  class RecoveryEstimator : public ErrorEstimator<dim>
  {
  public:
    Vector<double>
    indicators(ContactProblem<dim>   &problem,
               const LA::BlockVector &x) const override;
  };
} // namespace stickslip

#endif
