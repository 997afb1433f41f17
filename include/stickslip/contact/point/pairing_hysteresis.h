#ifndef stickslip_contact_point_pairing_hysteresis_h
#define stickslip_contact_point_pairing_hysteresis_h

#include <stickslip/contact/point/pairing.h>

namespace stickslip
{
  /// How far beyond its edges a master surface still is a point's partner.
  struct EdgeRetention
  {
    double overlap_factor = 0.;    ///< of 'Facet overlap'; 0: none
    bool   beyond_end     = false; ///< up to 'End overlap' beyond the surface
  };



  /**
   * What a contact point remembers of its pairings, and what that means for the
   * next one. The pairing in a state x is a function of x and of this memory:
   * find_partner() takes last() as the facet to start from and
   * retention(). Only the functions accept_iterate(), accept_step() and
   * restore() change the memory, once per accepted Newton iterate (or frozen
   * geometry) and step; evaluations of trial states do not.
   *
   * A point that switches between facets, as at a kink, keeps its facet beyond
   * the edge, the farther the longer this goes on; one that has lost and found
   * its partner as often, at the end of the master surface, keeps it until it
   * is well beyond. Only in steps that fail without that (activate()), and in
   * later ones while it lasts: which of two facets a point saw first would else
   * decide about its normal.
   */
  template <int dim>
  class PairingHysteresis
  {
  public:
    /// Changes of the facet in a step that widen the overlap by one level:
    /// Newton's first iterations explain fewer of them.
    static constexpr unsigned int facet_changes_per_level = 6;

    /// Changes of the partner in a step after which it is kept beyond the end.
    static constexpr unsigned int many_partner_changes = 4;

    /// The state at the end of the last accepted step, for checkpoints.
    struct Accepted
    {
      Pairing<dim> pairing;
      unsigned int facet_changes   = 0; ///< that later steps take notice of
      bool         kept_beyond_end = false;
    };

    /// The pairing in the last accepted iterate, or the frozen one.
    const Pairing<dim> &
    last() const
    {
      return last_pairing;
    }

    const Accepted &
    accepted() const
    {
      return at_last_step;
    }

    EdgeRetention
    retention() const;

    /// The iterate with the pairing @p found is accepted. True if the next
    /// pairing in the same state may be another one because of that.
    bool
    accept_iterate(const Pairing<dim> &found);

    /// The step that ends with the pairing @p found is accepted.
    void
    accept_step(const Pairing<dim> &found);

    /// Back to the last accepted step.
    void
    restore();

    /// Continues from @p state.
    void
    resume(const Accepted &state);

    /// From now on, or no more, changes in this step count for retention().
    void
    set_active(const bool active)
    {
      is_active = active;
    }

    bool
    active() const
    {
      return is_active;
    }

    /// From facet to facet in this step, so often that retention() widens the
    /// overlap when active.
    bool
    switches_facets() const;

    /// To and fro over the end of the master surface, so often that retention()
    /// keeps the partner when active.
    bool
    switches_at_end() const
    {
      return n_partner_changes >= many_partner_changes;
    }

    /// Calls @p relocate with each remembered pairing: the numbers of master
    /// faces have changed.
    template <typename Relocate>
    void
    relocate(const Relocate &relocate)
    {
      relocate(last_pairing);
      relocate(at_last_step.pairing);
    }

  private:
    Pairing<dim> last_pairing;
    unsigned int n_facet_changes   = 0; ///< in this step, and what was kept
    unsigned int n_partner_changes = 0; ///< lost or found in this step
    bool         is_active         = false;
    Accepted     at_last_step;

    unsigned int
    counted_facet_changes() const;

    bool
    keeps_beyond_end() const;
  };
} // namespace stickslip

#endif
