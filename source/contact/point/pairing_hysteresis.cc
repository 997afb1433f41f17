#include <stickslip/contact/point/pairing_hysteresis.h>

#include <algorithm>

namespace stickslip
{
  namespace
  {
    template <int dim>
    bool
    is_beyond_its_facet(const Pairing<dim> &pairing)
    {
      constexpr double roundoff = 1e-10;
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (pairing.paired &&
            (pairing.xi[d] < -roundoff || pairing.xi[d] > 1. + roundoff))
          return true;
      return false;
    }



    /// Factors of 'Facet overlap'.
    constexpr double       overlap_of_level[] = {0., 1., 10., 50.};
    constexpr unsigned int last_level         = 3;



    template <int dim>
    unsigned int
    overlap_level(const unsigned int n_facet_changes)
    {
      return std::min(n_facet_changes /
                        PairingHysteresis<dim>::facet_changes_per_level,
                      last_level);
    }
  } // namespace



  template <int dim>
  EdgeRetention
  PairingHysteresis<dim>::retention() const
  {
    const unsigned int level = overlap_level<dim>(counted_facet_changes());
    return {overlap_of_level[level], keeps_beyond_end()};
  }



  template <int dim>
  bool
  PairingHysteresis<dim>::accept_iterate(const Pairing<dim> &found)
  {
    const bool partner_changes = found.paired != last_pairing.paired;
    const bool facet_changes   = found.paired && last_pairing.paired &&
                               !found.is_on_same_part_as(last_pairing);
    n_partner_changes += partner_changes;
    n_facet_changes += facet_changes;
    last_pairing = found;
    return partner_changes || facet_changes;
  }



  template <int dim>
  void
  PairingHysteresis<dim>::accept_step(const Pairing<dim> &found)
  {
    accept_iterate(found);
    at_last_step.kept_beyond_end =
      keeps_beyond_end() && found.paired && !found.is_interior();
    // beyond its facet the point still needs what has kept it there
    at_last_step.facet_changes =
      is_beyond_its_facet(found) ? counted_facet_changes() : 0;
    at_last_step.pairing = found;
    restore();
  }



  template <int dim>
  void
  PairingHysteresis<dim>::restore()
  {
    last_pairing      = at_last_step.pairing;
    n_facet_changes   = at_last_step.facet_changes;
    n_partner_changes = 0;
  }



  template <int dim>
  void
  PairingHysteresis<dim>::resume(const Accepted &state)
  {
    at_last_step = state;
    restore();
  }



  template <int dim>
  bool
  PairingHysteresis<dim>::switches_facets() const
  {
    return overlap_level<dim>(n_facet_changes) >
           overlap_level<dim>(at_last_step.facet_changes);
  }



  template <int dim>
  unsigned int
  PairingHysteresis<dim>::counted_facet_changes() const
  {
    return is_active ? n_facet_changes : at_last_step.facet_changes;
  }



  template <int dim>
  bool
  PairingHysteresis<dim>::keeps_beyond_end() const
  {
    return at_last_step.kept_beyond_end || (is_active && switches_at_end());
  }



  template class PairingHysteresis<2>;
  template class PairingHysteresis<3>;
} // namespace stickslip
