#include <stickslip/base/duration.h>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace stickslip
{
  namespace
  {
    constexpr double minute = 60., hour = 60. * minute, day = 24. * hour;



    /// The non-negative number that is all of @p text.
    std::optional<double>
    whole_number(const std::string &text)
    {
      constexpr unsigned int most_digits = 9;
      if (text.empty() || text.size() > most_digits ||
          text.find_first_not_of("0123456789") != std::string::npos)
        return {};
      return std::stod(text);
    }



    /// "1-12:30:00" and its short forms; "12:30:00".
    std::optional<double>
    seconds_of_clock(const std::string &text)
    {
      const auto  dash     = text.find('-');
      const bool  has_days = dash != std::string::npos;
      double      seconds  = 0.;
      std::string rest     = text;
      if (has_days)
        {
          const auto days = whole_number(text.substr(0, dash));
          if (!days)
            return {};
          seconds = *days * day;
          rest    = text.substr(dash + 1);
        }
      const std::vector<double> units{hour, minute, 1.};
      std::istringstream        fields(rest + ":");
      unsigned int              n = 0;
      for (std::string field; std::getline(fields, field, ':'); ++n)
        {
          const auto number = whole_number(field);
          if (!number || n == units.size() || (n > 0 && *number >= 60.))
            return {};
          seconds += *number * units[n];
        }
      if (n == units.size() || has_days)
        return seconds;
      return {};
    }



    /// "1 d 12 h", "90min".
    std::optional<double>
    seconds_of_units(const std::string &text)
    {
      static const std::map<std::string, double> units = {
        {"s", 1.}, {"sec", 1.}, {"min", minute}, {"h", hour}, {"d", day}};
      std::istringstream in(text);
      double             seconds = 0., number = 0.;
      std::string        unit;
      unsigned int       n = 0;
      for (; in >> std::ws, !in.eof(); ++n)
        {
          if (!(in >> number >> unit) || units.count(unit) == 0 ||
              !(number >= 0.))
            return {};
          seconds += number * units.at(unit);
        }
      if (n > 0 && std::isfinite(seconds))
        return seconds;
      return {};
    }
  } // namespace



  std::optional<double>
  seconds_of_duration(const std::string &text)
  {
    const auto of_clock = seconds_of_clock(text);
    return of_clock ? of_clock : seconds_of_units(text);
  }



  std::string
  duration_in_words(const double seconds)
  {
    const long total      = std::lround(seconds);
    const auto two_digits = [](const long n) {
      return (n < 10 ? "0" : "") + std::to_string(n);
    };
    if (total < 60)
      return std::to_string(total) + " s";
    if (total < 3600)
      return std::to_string(total / 60) + " min " + two_digits(total % 60) +
             " s";
    return std::to_string(total / 3600) + " h " +
           two_digits(total % 3600 / 60) + " min";
  }
} // namespace stickslip
