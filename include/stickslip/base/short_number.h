#ifndef stickslip_base_short_number_h
#define stickslip_base_short_number_h

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace stickslip
{
  /// A number for people: at most six digits.
  inline std::string
  short_number(const double value)
  {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
  }

  /// A size for people: two digits or all before the point, and no exponent.
  inline std::string
  rough_number(const double value)
  {
    const double size = std::abs(value);
    if (size > 0. && size < 1e-4)
      return "less than 0.0001";
    std::array<char, 512> text; // for 1e308
    std::snprintf(text.data(),
                  text.size(),
                  size < 9.95 ? "%.2g" : "%.0f",
                  value);
    return text.data();
  }

  /// The part @p fraction of something, as "12 %".
  inline std::string
  percent(const double fraction)
  {
    return rough_number(100. * fraction) + " %";
  }
} // namespace stickslip

#endif
