#ifndef stickslip_contact_point_automatic_contact_h
#define stickslip_contact_point_automatic_contact_h

#include <stickslip/contact/point/contact_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /// Contact between all bodies that no pair of the user names: what the
  /// section "Contact" has beside the pairs.
  struct AutomaticContact
  {
    bool   active               = false;
    double friction_coefficient = 0.;    ///< Coulomb's mu; 0: no friction
    bool   self_contact         = false; ///< of each body with itself

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError about the section @p path.
    void
    check(const std::string &path) const;

    /// The parameters of such a pair, apart from its surfaces.
    ContactPairParameters
    pair() const;
  };
} // namespace stickslip

#endif
