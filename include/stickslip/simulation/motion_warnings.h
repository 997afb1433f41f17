#ifndef stickslip_simulation_motion_warnings_h
#define stickslip_simulation_motion_warnings_h

#include <stickslip/output/contact_resultants.h>

#include <stickslip/simulation/case_parameters.h>

#include <stickslip/problem/contact_problem.h>

#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /// Looks in accepted steps for motions of whole bodies that are probably not
  /// what the user wants. Each body is reported once.
  template <int dim>
  class MotionWarnings
  {
  public:
    /// The arguments must outlive this object. Collective.
    MotionWarnings(const CaseParameters      &parameters,
                   const Bodies              &bodies,
                   const ContactProblem<dim> &problem);

    /// Texts about the step with these resultants, one per pair. Collective.
    std::vector<std::string>
    of_step(const std::vector<ContactResultants<dim>> &resultants,
            const ContactProblem<dim>                 &problem);

    /// What nothing resists in the last step: free motions of bodies that no
    /// contact pair touches.
    const std::vector<FreeMotion> &
    adrift() const
    {
      return unresisted;
    }

  private:
    /// A body whose law knows small strains only.
    struct SmallStrainBody
    {
      unsigned int body;
      std::string  material, law;
    };

    const CaseParameters         &parameters;
    const Bodies                 &bodies;
    const std::vector<FreeMotion> free; ///< but for contact
    std::vector<FreeMotion>       unresisted;
    std::set<std::string>         reported;            ///< of those
    std::vector<SmallStrainBody>  small_strain_bodies; ///< not yet reported

    void
    find_adrift(const std::vector<ContactResultants<dim>> &resultants,
                std::vector<std::string>                  &texts);

    void
    look_at_rotations(const ContactProblem<dim> &problem,
                      std::vector<std::string>  &texts);
  };
} // namespace stickslip

#endif
