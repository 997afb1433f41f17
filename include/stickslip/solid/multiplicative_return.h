#ifndef stickslip_solid_multiplicative_return_h
#define stickslip_solid_multiplicative_return_h

#include <stickslip/solid/elastic_constants.h>
#include <stickslip/solid/isotropic_hardening.h>
#include <stickslip/solid/kinematic_hardening.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace stickslip
{
  /**
   * Plastic flow at large strains with kinematic hardening, F = F^e F^p with
   * Hencky's elasticity of C^e = F^eT F^e. Each back stress has a split of its
   * own, F^p = F^pe F^pi: the part F^pe of the plastic deformation is stored,
   * the other is recovered,
   *
   *   X_k = 2/3 C_k a_k,   a_k = 1/2 ln(F^pe F^peT),
   *
   * as elastic strains store the stress (Lion, Int. J. Plast. 16, 2000;
   * Vladimirov, Pietryga and Reese, Int. J. Numer. Meth. Engng. 75, 2008, with
   * neo-Hookean energies). X is a strain of the intermediate configuration and
   * not the integral of a corotational rate, so that it does not oscillate in
   * simple shear. Without back stresses the law is that of isotropic hardening
   * on all paths. (An additive split of the logarithmic strain (Miehe, Apel and
   * Lambrecht, CMAME 191, 2002), which is simpler, agrees with it on coaxial
   * paths only.)
   *
   * All tensors are in the intermediate configuration of the beginning of the
   * step. With the flow A = dp 3/2 (dev T - X) / R, T = K tr(e) I + 2 mu dev e
   * the Mandel stress to e = 1/2 ln C^e, and G = exp(A)
   *
   *   C^e = G^-1 C_trial G^-1,
   *   a_k = 1/2 ln(exp(gained A) exp(2 kept a_k,old) exp(gained A))
   *
   * (BackStress::Evolution): plastic volumes are conserved exactly, and
   * proportional loading is integrated exactly. A is not coaxial with C_trial
   * in general. It is found by Newton's method, which begins with the answer
   * to an additive split of the logarithmic strains (mixed_return()).
   */
  struct MultiplicativeReturn
  {
    double                        dp = 0.; ///< of the equivalent plastic strain
    dealii::SymmetricTensor<2, 3> elastic_metric; ///< C^e
    dealii::Tensor<2, 3>          inverse_G;      ///< exp(-A), I if elastic
    dealii::SymmetricTensor<4, 3> dinverse_G;     ///< over C_trial
  };

  /// Solves it and moves @p back_strains to the end of the step. Returns false
  /// if there is no solution within 50 iterations.
  bool
  multiplicative_return(const dealii::SymmetricTensor<2, 3> &C_trial,
                        const double                         p_old,
                        const IsotropicHardening            &hardening,
                        const KinematicHardening            &kinematic,
                        const ElasticConstants              &elastic,
                        KinematicHardening::BackStrains     &back_strains,
                        MultiplicativeReturn                &result);
} // namespace stickslip

#endif
