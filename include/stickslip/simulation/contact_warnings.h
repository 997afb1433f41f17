#ifndef stickslip_simulation_contact_warnings_h
#define stickslip_simulation_contact_warnings_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/contact/point/contact_parameters.h>

#include <stickslip/mesh/body_parameters.h>

#include <stickslip/output/contact_resultants.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// Looks for parameters and accepted steps that are probably not what the
  /// user wants.
  class ContactWarnings
  {
  public:
    ContactWarnings(const NamedList<ContactPairParameters> &pairs,
                    const NamedList<BodyParameters>        &bodies);

    /// Texts about questionable parameters.
    const std::vector<std::string> &
    of_parameters() const
    {
      return about_parameters;
    }

    /// Texts about the step with these resultants, one per pair. A pair is
    /// reported when it gets into a strange state, not while it stays there.
    template <int dim>
    std::vector<std::string>
    of_step(const std::vector<ContactResultants<dim>> &resultants);

    /// Texts about all steps that of_step() has seen.
    std::vector<std::string>
    at_end() const;

  private:
    std::vector<std::string> names;
    std::vector<bool>        may_be_far;   ///< without that being a mistake
    std::vector<bool>        may_stay_far; ///< in all steps
    std::vector<std::string> about_parameters;
    std::vector<bool>        is_paired;  ///< any point, at the last step
    std::vector<bool>        was_paired; ///< any point, at any step
    std::vector<bool>        was_closed; ///< likewise
    unsigned int             n_steps = 0;
  };
} // namespace stickslip

#endif
