#ifndef stickslip_contact_cycling_status_history_h
#define stickslip_contact_cycling_status_history_h

#include <stickslip/contact/assembly/contact_assembler.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /// A sequence that repeats with a period of 2 to 6 iterations.
  struct StatusCycle
  {
    unsigned int period = 0; ///< 0: none

    explicit operator bool() const
    {
      return period > 0;
    }
  };



  /// Between what a contact point alternates; the first that applies.
  enum class CycleKind
  {
    pairing,   ///< paired, unpaired
    contact,   ///< closed, open
    stick,     ///< stick, slip
    direction, ///< slip to and fro (turns of more than 90 degrees)
    facet      ///< only the master facet (or its interior and its edge) changes
  };

  constexpr unsigned int n_cycle_kinds = 5;

  /// "contact/open" and so on, for messages and tables.
  std::string
  name_of(const CycleKind kind);



  /// What was done last about the cycle of a contact point.
  enum class PointTreatment
  {
    none,
    other_r_n, ///< another regularization parameter
    other_r_t,
    fixed_closed, ///< the status keeps this value until all has converged
    fixed_open,
    fixed_stick,
    fixed_slip
  };

  /// "another r_n" and so on; empty: none.
  std::string
  name_of(const PointTreatment treatment);



  /// A contact point of this rank whose last statuses repeat.
  struct PointCycle
  {
    unsigned int pair;  ///< index in ContactAssembler::contact_pairs()
    unsigned int point; ///< index in ContactPair::points
    CycleKind    kind;
    unsigned int period;        ///< 2 to 6
    bool         changes_facet; ///< perhaps with a change of status
  };



  /**
   * What every contact point did in the last Newton iterations, and whether its
   * statuses cycle. Use:
   *
   *   history.clear();                 // a solve begins
   *   history.record(contact);         // once per Newton iteration, after the
   *                                    // tangent (or residual) was assembled
   *   if (history.cycle())             // proven, on all ranks alike
   *     for (const auto &p : history.cycling_points()) ...  // own points
   *
   * A record is what ContactPoint::observed and ContactPoint::frame hold, so it
   * costs no evaluation: status, sense of slip and master facet, one 32-bit
   * code per point, of the last `capacity` iterations. A point's sense of slip
   * is relative: it turns over when the direction of slip has turned by more
   * than 90 degrees since the point slipped last.
   *
   * A cycle counts as proven when the codes of all points of all pairs and
   * ranks together have repeated for `n_periods` periods: the tangents of
   * Newton's method, whose statuses they are, then repeat as well. Codes of all
   * points are compared by a 64-bit hash that neither order nor partition
   * changes (XOR over the points of a hash of name and code), with one
   * reduction per record.
   */
  template <int dim>
  class StatusHistory
  {
  public:
    static constexpr unsigned int capacity       = 32; ///< iterations
    static constexpr unsigned int longest_period = 6;
    static constexpr unsigned int n_periods      = 3; ///< that prove a cycle

    /// Forgets everything. Not collective.
    void
    clear();

    /// Forgets the records, so that what is proven from now on is new, but not
    /// the treatments. Not collective.
    void
    forget_records();

    /// Adds what the points of @p contact are doing. Collective.
    void
    record(const ContactAssembler<dim> &contact);

    /// Number of records since clear(); the last `capacity` of them are kept.
    unsigned int
    n_records() const
    {
      return n_recorded;
    }

    /// The cycle that the last records of all points prove, the same on all
    /// ranks. A constant sequence is none. Not collective.
    StatusCycle
    cycle() const;

    /// The points of this rank whose own last records repeat for `n_periods`
    /// periods, whatever the other points do. In the order of pairs and points.
    /// Not collective.
    std::vector<PointCycle>
    cycling_points() const;

    /**
     * The kept records of a point of this rank, oldest first, a letter each:
     * u unpaired, o open, s stick, f and b slip (forward: as when it slipped
     * first; backward), c closed without friction or without pressure yet. Not
     * collective.
     */
    std::string
    text(const unsigned int pair, const unsigned int point) const;

    /// Remembers what was done about a point of this rank, for the diagnosis,
    /// until clear(). Not collective.
    void
    note_treatment(const unsigned int   pair,
                   const unsigned int   point,
                   const PointTreatment treatment);

    /// What note_treatment() was told last. Not collective.
    PointTreatment
    treatment(const unsigned int pair, const unsigned int point) const;

    /// How often a point of this rank has changed its facet among the kept
    /// records. Not collective.
    unsigned int
    n_facet_changes(const unsigned int pair, const unsigned int point) const;

  private:
    using Code = std::uint32_t;

    struct PointRecords
    {
      std::array<Code, capacity> codes;          ///< a ring
      Tensor<1, dim>             last_direction; ///< when it slipped last
      bool                       is_backward = false;
      std::uint64_t              name_hash   = 0;
    };

    std::vector<std::vector<PointRecords>> points; ///< by pair
    std::array<std::uint64_t, capacity>    hashes; ///< of all points, a ring
    unsigned int                           n_recorded = 0;

    std::map<std::pair<unsigned int, unsigned int>, PointTreatment> treatments;

    void
    name_points(const ContactAssembler<dim> &contact);

    static Code
    encode(const ContactPoint<dim> &point, PointRecords &records);
  };
} // namespace stickslip

#endif
