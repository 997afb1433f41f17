#ifndef stickslip_base_duration_h
#define stickslip_base_duration_h

#include <optional>
#include <string>

namespace stickslip
{
  /**
   * Seconds in a duration of wall-clock time as people or batch systems write
   * it: numbers with units ("3 h", "1 d 12 h", "1.5 h", "90 min", "45 s"),
   * "hours:minutes:seconds", "days-hours", "days-hours:minutes" or
   * "days-hours:minutes:seconds". Nothing if @p text is none of these, also for
   * a number without unit and for "12:30", which mean different things to
   * different readers.
   */
  std::optional<double>
  seconds_of_duration(const std::string &text);

  /// "45 s", "3 min 20 s", "2 h 05 min".
  std::string
  duration_in_words(const double seconds);
} // namespace stickslip

#endif
