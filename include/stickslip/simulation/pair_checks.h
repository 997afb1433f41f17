#ifndef stickslip_simulation_pair_checks_h
#define stickslip_simulation_pair_checks_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/contact/point/contact_parameters.h>

#include <stickslip/strategy/solution_strategy.h>

namespace stickslip
{
  /// Two pairs of the same surfaces would press twice: throws UserError.
  void
  check_pairs_differ(const NamedList<ContactPairParameters> &pairs);

  /// Throws UserError if the algorithm needs a law that holds at each
  /// multiplier, and a pair has none.
  void
  check_pairs_suit(const Algorithm                         algorithm,
                   const NamedList<ContactPairParameters> &pairs);
} // namespace stickslip

#endif
