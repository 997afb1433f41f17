#include <stickslip/contact/point/pair_law.h>

namespace stickslip
{
  const Choices<PairLaw> &
  all_pair_laws()
  {
    static const Choices<PairLaw> choices = {{"contact", PairLaw::contact},
                                             {"tied", PairLaw::tied},
                                             {"no separation",
                                              PairLaw::no_separation}};
    return choices;
  }
} // namespace stickslip
