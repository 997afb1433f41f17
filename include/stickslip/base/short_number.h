#ifndef stickslip_base_short_number_h
#define stickslip_base_short_number_h

#include <array>
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
} // namespace stickslip

#endif
