#include <stickslip/strategy/back_off.h>

#include <algorithm>

namespace stickslip
{
  void
  BackOff::fail()
  {
    length = std::clamp(2 * length, first, longest);
    restart();
  }



  void
  BackOff::succeed()
  {
    length /= 2;
    left = std::min(left, length);
  }



  void
  BackOff::advance()
  {
    left = std::max(left, 1U) - 1;
  }



  void
  BackOff::resume(const unsigned int wait_length, const unsigned int steps_left)
  {
    length = std::min(wait_length, longest);
    left   = std::min(steps_left, length);
  }
} // namespace stickslip
