#ifndef stickslip_base_short_message_h
#define stickslip_base_short_message_h

#include <exception>
#include <string>

namespace stickslip
{
  /// The message of a deal.II exception without its decoration (file, line,
  /// stack), in one line.
  std::string
  short_message(const std::exception &exception);
} // namespace stickslip

#endif
