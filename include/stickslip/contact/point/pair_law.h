#ifndef stickslip_contact_point_pair_law_h
#define stickslip_contact_point_pair_law_h

#include <stickslip/base/choice.h>

namespace stickslip
{
  /// What the two surfaces of a pair may do to each other.
  enum class PairLaw
  {
    contact,      ///< part, touch, stick and slip
    tied,         ///< bonded: neither part nor slip
    no_separation ///< neither part nor overlap, but slip freely
  };

  const Choices<PairLaw> &
  all_pair_laws();

  /// True if the surfaces cannot part: the normal law has two sides.
  inline bool
  is_bilateral(const PairLaw law)
  {
    return law != PairLaw::contact;
  }
} // namespace stickslip

#endif
