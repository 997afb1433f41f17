#include <stickslip/contact/point/initial_gaps.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <cmath>

namespace stickslip
{
  const Choices<InitialGapTreatment> &
  all_initial_gap_treatments()
  {
    static const Choices<InitialGapTreatment> choices = {
      {"as meshed", InitialGapTreatment::as_meshed},
      {"closed", InitialGapTreatment::closed}};
    return choices;
  }



  void
  InitialGaps::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Initial gaps",
               treatment,
               all_initial_gap_treatments(),
               "as meshed: the bodies are where their meshes are. closed: gaps "
               "and overlaps of the meshes up to 'Initial gap tolerance' are "
               "closed at the start, without stress.");
    prm.add_parameter(
      "Initial gap tolerance",
      tolerance,
      "With 'Initial gaps = closed': the largest gap or overlap "
      "that is closed [length].",
      Patterns::Double(0.));
    prm.add_parameter("Overlap ramp time",
                      ramp_time,
                      "Overlaps of the meshes (a press fit) come into effect "
                      "linearly until this load time. 0: at once. Of a pair "
                      "that cannot part ('Law'): gaps and overlaps of the "
                      "start are drawn closed until this time. 0: they stay.",
                      Patterns::Double(0.));
    prm.add_parameter("Largest initial overlap",
                      largest_overlap,
                      "A larger overlap of the meshes is an error [length]. 0: "
                      "none is.",
                      Patterns::Double(0.));
  }



  void
  InitialGaps::check(const std::string &path) const
  {
    const bool is_closed = treatment == InitialGapTreatment::closed;
    if (is_closed && !(tolerance > 0.))
      throw UserError("'" + path +
                      "/Initial gap tolerance' must be larger than 0 with "
                      "'Initial gaps = closed'.");
    if (!is_closed && tolerance > 0.)
      throw UserError("'" + path +
                      "/Initial gap tolerance' is given, but 'Initial gaps = "
                      "as meshed'. Set 'Initial gaps = closed' or remove it.");
  }



  double
  InitialGaps::offset(const double depth, const double time) const
  {
    if (treatment == InitialGapTreatment::closed &&
        std::abs(depth) <= tolerance)
      return depth;
    if (depth > 0. && ramp_time > 0.)
      return depth * std::max(0., 1. - time / ramp_time);
    return 0.;
  }



  double
  InitialGaps::kept_share(const double time) const
  {
    return ramp_time > 0. ? std::max(0., 1. - time / ramp_time) : 1.;
  }
} // namespace stickslip
