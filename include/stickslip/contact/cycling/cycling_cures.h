#ifndef stickslip_contact_cycling_cycling_cures_h
#define stickslip_contact_cycling_cycling_cures_h

#include <stickslip/base/cycle_treatment.h>

#include <stickslip/contact/cycling/admissible_scale.h>
#include <stickslip/contact/cycling/status_history.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// The section "Algorithm/Cycling".
  struct CyclingParameters
  {
    bool adapt_scales  = true;
    bool hold_statuses = true;

    void
    add_parameters(ParameterHandler &prm);
  };



  /// What the cures have done since the last reset.
  struct CureCounts
  {
    unsigned int cycles         = 0; ///< that were proven
    unsigned int adapted_scales = 0; ///< points with another r
    unsigned int held_statuses  = 0; ///< points whose status was held
  };



  /**
   * Finds points whose statuses go round in circles while a residual does not
   * become smaller, and breaks the circle (paper, section 6):
   *
   * 1. closed/open, stick/slip, slip to and fro: the nearest r to the stiffness
   *    of the contact for which the last two states have the same status
   *    (paper, eqs. 29 and 32). Only with nodal quadrature, where no answer
   *    depends on r.
   * 2. If no r does, or the point cycles again: its status is held (closed,
   *    stick; the next time open, slip) until the residual has converged; then
   *    release() gives all statuses free, so that what is accepted satisfies
   *    the contact law everywhere.
   *
   * Points of facet and pairing cycles are left alone. All functions are
   * collective.
   */
  template <int dim>
  class CyclingCures
  {
  public:
    CyclingCures(const CyclingParameters &parameters,
                 ContactAssembler<dim>   &contact);

    /// A step begins: no point learns from its changes of facet and partner.
    void
    begin_step();

    /// A solve begins: forgets statuses and holds, not the scales.
    void
    begin_solve();

    /// Records the last residual's statuses. With @p act the points of a proven
    /// cycle are treated.
    CycleTreatment
    observe(const bool act);

    /// What the last observe() did, empty if there is nothing to say.
    const std::string &
    description() const
    {
      return text;
    }

    /// Frees all held statuses. True if there were any.
    bool
    release();

    /// Some points hop and do not learn from it yet although their overlaps are
    /// not 0: let_points_learn() would change their pairing.
    bool
    learning_would_help() const;

    /// From now on all points learn in this step
    /// (PairingHysteresis::set_active).
    void
    let_points_learn();

    /// use_natural_scales() would change an r by more than a factor of two.
    bool
    natural_scales_differ() const;

    /// All r at the stiffness of the contact, as the last iteration knew it.
    void
    use_natural_scales();

    const StatusHistory<dim> &
    history() const
    {
      return statuses;
    }

    CureCounts counts;

  private:
    const CyclingParameters parameters;
    ContactAssembler<dim>  &contact;
    StatusHistory<dim>      statuses;
    std::vector<std::vector<StatusState<dim>>>
      before; ///< [pair][point], last iterate
    std::vector<std::vector<StatusState<dim>>> now;
    std::string                                text;

    void
    read_states();

    /// Whether another r leaves the answer of @p pair as it is, and may be used.
    bool
    scales_may_change(const ContactPair<dim> &pair) const;

    bool
    adapt_scale(const PointCycle &cycle);

    bool
    hold_status(const PointCycle &cycle);
  };
} // namespace stickslip

#endif
