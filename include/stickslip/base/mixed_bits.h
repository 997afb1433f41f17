#ifndef stickslip_base_mixed_bits_h
#define stickslip_base_mixed_bits_h

#include <cstdint>

namespace stickslip
{
  /// Spreads every bit of @p value over all bits: a bijection whose values look
  /// random (splitmix64: Steele, Lea and Flood, OOPSLA 2014).
  inline std::uint64_t
  mixed_bits(std::uint64_t value)
  {
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31);
  }
} // namespace stickslip

#endif
