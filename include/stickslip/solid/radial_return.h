#ifndef stickslip_solid_radial_return_h
#define stickslip_solid_radial_return_h

#include <stickslip/solid/isotropic_hardening.h>
#include <stickslip/solid/kinematic_hardening.h>

#include <deal.II/base/symmetric_tensor.h>

namespace stickslip
{
  /**
   * Result of the return mapping of von Mises plasticity with associated flow
   * and isotropic hardening, for a trial stress of von Mises norm q:
   *
   *   q - 3 mu dp = R(p_old + dp).
   */
  struct RadialReturn
  {
    bool   is_plastic = false;
    double dp         = 0.; ///< increment of the equivalent plastic strain
    double slope      = 0.; ///< R' at the end

    /// Deviatoric stress over its trial value: 1 - 3 mu dp / q.
    double scale = 1.;

    /**
     * The algorithmic tangent is K I x I + 2 mu scale I_dev
     * - reduction N x N, N the unit direction of the trial stress:
     * 6 mu^2 (1 / (3 mu + R') - dp / q).
     */
    double reduction = 0.;
  };

  /**
   * Solves it by Newton's method within the interval that must contain dp, so
   * that it always ends. Returns false if @p q is not a number, or if there is
   * no solution within 100 iterations. @p shear_modulus may differ from the
   * elastic one (Simo-Miehe); @p q and it are in the units of stress.
   */
  bool
  radial_return(const double              q,
                const double              shear_modulus,
                const double              p_old,
                const IsotropicHardening &hardening,
                const ElasticConstants   &elastic,
                RadialReturn             &result);



  /**
   * Result of the return mapping with kinematic hardening beside, for an
   * additive split of the strain. The plastic flow is A = sqrt(3/2) dp N, the
   * stress s = s_trial - 2 mu A, the back strains a_k develop as
   * BackStress::Evolution says, and with X = sum 2/3 C_k a_k
   *
   *   s - X = sqrt(2/3) R(p_old + dp) N.
   *
   * N is the direction of xi = s_trial - sum 2/3 C_k kept_k a_k, which
   * recovery turns with dp, so that one equation for dp remains:
   *
   *   |xi|_vM - 3 mu dp - sum C_k gained_k dp = R(p_old + dp).
   *
   * Its left side less its right one falls with dp, because a back strain is
   * at most 1/gamma in the von Mises sense: there is one solution.
   */
  struct MixedReturn
  {
    bool   is_plastic = false;
    double dp         = 0.; ///< increment of the equivalent plastic strain

    dealii::SymmetricTensor<2, 3> flow; ///< A

    /// The algorithmic tangent is K I x I + 2 mu scale I_dev - V x N with the
    /// unit tensor N and V = reduction N + what recovery turns the flow by, so
    /// that it is symmetric without recovery.
    double                        scale = 1.;
    dealii::SymmetricTensor<2, 3> N, V;
  };

  /// Solves it, as radial_return() does. @p trial_stress is deviatoric. Also
  /// moves @p back_strains to the end of the step.
  bool
  mixed_return(const dealii::SymmetricTensor<2, 3> &trial_stress,
               const double                         p_old,
               const IsotropicHardening            &hardening,
               const KinematicHardening            &kinematic,
               const ElasticConstants              &elastic,
               KinematicHardening::BackStrains     &back_strains,
               MixedReturn                         &result);
} // namespace stickslip

#endif
