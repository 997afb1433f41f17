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

  /// For the screen: @p text with what nobody reads left out of the middle of
  /// words of more than 400 and of texts of more than 20,000 characters.
  std::string
  without_long_words(const std::string &text);
} // namespace stickslip

#endif
