#ifndef stickslip_contact_point_initial_gaps_h
#define stickslip_contact_point_initial_gaps_h

#include <stickslip/base/choice.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace stickslip
{
  using namespace dealii;

  /// What small gaps and overlaps of the undeformed bodies are taken for.
  enum class InitialGapTreatment
  {
    as_meshed, ///< what they are
    closed     ///< inaccuracies of the mesh
  };

  const Choices<InitialGapTreatment> &
  all_initial_gap_treatments();



  /// What becomes of gaps and overlaps that are there at the start.
  struct InitialGaps
  {
    InitialGapTreatment treatment       = InitialGapTreatment::as_meshed;
    double              tolerance       = 0.; ///< [length]
    double              ramp_time       = 0.; ///< [load time]; 0: no ramp
    double              largest_overlap = 0.; ///< [length]; 0: any

    void
    add_parameters(ParameterHandler &prm);

    void
    check(const std::string &path) const;

    /// What is added to the gap [length] at @p time of a point that is
    /// @p depth behind its partner where nothing is deformed (negative: an
    /// open gap).
    double
    offset(const double depth, const double time) const;

    /// What is left at @p time of the gaps and overlaps between surfaces that
    /// cannot part, as a fraction.
    double
    kept_share(const double time) const;

    /// Whether any offset() is not zero.
    bool
    changes_gaps() const
    {
      return treatment != InitialGapTreatment::as_meshed || ramp_time > 0.;
    }
  };
} // namespace stickslip

#endif
