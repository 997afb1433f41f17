#ifndef stickslip_contact_cycling_status_cycle_treatment_h
#define stickslip_contact_cycling_status_cycle_treatment_h

#include <stickslip/base/cycle_treatment.h>

#include <stickslip/contact/cycling/admissible_scale.h>
#include <stickslip/contact/cycling/status_history.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <optional>
#include <vector>

namespace stickslip
{
  /// The section "Algorithm/Cycling".
  struct CyclingParameters
  {
    bool adapt_scales  = true;
    bool fix_statuses  = true;
    bool round_corners = true;

    void
    add_parameters(ParameterHandler &prm);
  };



  /// What was found and done where points cycled: numbers of points, of all
  /// ranks.
  struct CycleReport
  {
    std::array<unsigned int, n_cycle_kinds> n_cycling{}; ///< by CycleKind
    unsigned int n_other_r = 0; ///< have another r since
    unsigned int n_fixed   = 0; ///< have a fixed status since

    bool
    any_treated() const
    {
      return n_other_r + n_fixed > 0;
    }
  };



  /// What was done since the last reset.
  struct CycleTreatmentCounts
  {
    unsigned int cycles         = 0; ///< that were proven
    unsigned int adapted_scales = 0; ///< points with another r
    unsigned int fixed_statuses = 0; ///< points whose status was fixed
  };



  /**
   * Finds points whose statuses cycle while a residual does not become smaller,
   * and ends the cycle (paper, section 6):
   *
   * 1. closed/open, stick/slip, slip to and fro: the nearest r to the automatic
   *    one for which the last two states have the same status (paper, eqs. 29
   *    and 32). Only with segments and nodal quadrature, where no answer
   * depends on r.
   * 2. If no r does, or the point cycles again: its status is fixed (closed,
   *    stick; the next time open, slip) until the residual has converged; then
   *    release() frees all statuses, so that what is accepted satisfies the
   *    contact law everywhere.
   *
   * A point is treated at most three times in a solve. Points whose facet or
   * pairing cycles are left alone. All functions are collective.
   */
  template <int dim>
  class StatusCycleTreatment
  {
  public:
    StatusCycleTreatment(const CyclingParameters &parameters,
                         ContactAssembler<dim>   &contact);

    /// A step begins: points are paired without hysteresis.
    void
    begin_step();

    /// A solve begins: forgets statuses, fixed ones too, not the scales.
    void
    begin_solve();

    /// Records the last residual's statuses. With @p act the points of a proven
    /// cycle are treated.
    CycleTreatment
    observe(const bool act);

    /// What the last observe() found and did; nothing if it did not act or no
    /// point cycled.
    const std::optional<CycleReport> &
    last_report() const
    {
      return report;
    }

    /// LawContinuation is allowed.
    bool
    may_round_corners() const
    {
      return parameters.round_corners;
    }

    /// Frees all fixed statuses. True if there were any.
    bool
    release();

    /// Some points switch facets without hysteresis although their overlaps are
    /// not 0: activate_hysteresis() would change their pairing.
    bool
    hysteresis_would_help() const;

    /// Pairs all points with hysteresis in the rest of this step
    /// (PairingHysteresis::set_active).
    void
    activate_hysteresis();

    /// use_default_scales() would change an r by more than a factor of two.
    bool
    default_scales_differ() const;

    /// All r at their automatic values, as the last iteration knew them.
    void
    use_default_scales();

    const StatusHistory<dim> &
    history() const
    {
      return statuses;
    }

    CycleTreatmentCounts counts;

  private:
    const CyclingParameters parameters;
    ContactAssembler<dim>  &contact;
    StatusHistory<dim>      statuses;
    std::vector<std::vector<StatusState<dim>>>
      before; ///< [pair][point], last iterate
    std::vector<std::vector<StatusState<dim>>> now;
    std::optional<CycleReport>                 report;

    void
    read_states();

    /// Whether another r leaves the answer of @p pair as it is, and may be used.
    bool
    scales_may_change(const ContactPair<dim> &pair) const;

    /// Treats the points of this rank, and sums up what all ranks did.
    CycleReport
    treat(const std::vector<PointCycle> &cycles);

    /// True if another r helps.
    bool
    adapt_scale(const PointCycle &cycle);

    void
    fix_status(const PointCycle &cycle);
  };
} // namespace stickslip

#endif
