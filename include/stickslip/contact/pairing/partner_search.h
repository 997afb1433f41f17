#ifndef stickslip_contact_pairing_partner_search_h
#define stickslip_contact_pairing_partner_search_h

#include <stickslip/contact/pairing/possible_penetration.h>

namespace stickslip
{
  /**
   * Pairs a slave point with a master point of @p patch: on the nearest face on
   * which it projects, else on the nearest edge or corner. Only master facets
   * that look at the slave are considered, and a negative gap only if it can be
   * a penetration (possible_penetration.h). Does not depend on the order of
   * faces. The face of @p last, the pairing to start from, is kept while the
   * projection is at most `facet_overlap` times the factor of @p retention
   * outside of it, and with EdgeRetention::beyond_end the point has a partner
   * up to `end_overlap` beyond the end of the surface: without that a point at
   * a kink or at the end may change its partner indefinitely. The tangent basis
   * is not set. Not collective.
   */
  template <int dim>
  Pairing<dim>
  find_partner(const MasterPatch<dim>    &patch,
               const SearchingPoint<dim> &point,
               const Pairing<dim>        &last,
               const EdgeRetention       &retention);
} // namespace stickslip

#endif
