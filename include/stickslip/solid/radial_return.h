#ifndef stickslip_solid_radial_return_h
#define stickslip_solid_radial_return_h

#include <stickslip/solid/isotropic_hardening.h>

namespace stickslip
{
  /**
   * Result of the return mapping of von Mises plasticity with associated flow,
   * for a trial stress of von Mises norm q:
   *
   *   q - (3 mu + H_kin) dp = R(p_old + dp).
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
     * 6 mu^2 (1 / (3 mu + H_kin + R') - dp / q).
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
                const double              kinematic_slope,
                const double              p_old,
                const IsotropicHardening &hardening,
                const ElasticConstants   &elastic,
                RadialReturn             &result);
} // namespace stickslip

#endif
