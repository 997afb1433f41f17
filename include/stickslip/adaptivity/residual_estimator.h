#ifndef stickslip_adaptivity_residual_estimator_h
#define stickslip_adaptivity_residual_estimator_h

#include <stickslip/adaptivity/error_estimator.h>

namespace stickslip
{
  /**
   * What the stresses lack of equilibrium, in the undeformed configuration,
   * with the first Piola-Kirchhoff stress P, the shear modulus mu of the
   * undeformed material, h the diameters of cells and faces, p the degree:
   *
   *   eta_K^2 = c h_K^2 / (2 mu p^2) int_K |Div P + b|^2
   *     + sum_F c h_F / (2 mu p) 1/2 int_F |[P N]|^2       inner faces
   *     + sum_F c h_F / (2 mu p) int_F |Pi (t - P N)|^2    boundary faces
   *     + what is left of the contact law on slave faces (ContactResidual).
   *
   * (Verfuerth, A Posteriori Error Estimation Techniques, 2013, section 4.9.)
   * t is the sum of the loads and of what contact transfers, on both surfaces,
   * so that the stresses of either body are compared with the multipliers.
   * Pi projects on the directions in which the nodes of the face can move: in
   * the others tractions are reactions, and contact may have left a node to
   * them: both are taken node by node. Stresses are polynomials through their
   * values at the quadrature points (CellStresses), so that those of laws with
   * a history have a divergence.
   *
   * The constant between residual and error depends on the shape of the cells,
   * not on their size; c = 1/36 brings it near to one on regular meshes. Not
   * seen: viscous stabilization, the jumps over periodic boundaries, surfaces
   * that are tied and do not fit.
   */
  template <int dim>
  class ResidualEstimator : public ErrorEstimator<dim>
  {
  public:
    Vector<double>
    indicators(ContactProblem<dim>   &problem,
               const LA::BlockVector &x) const override;
  };
} // namespace stickslip

#endif
