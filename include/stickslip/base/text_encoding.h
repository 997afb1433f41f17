#ifndef stickslip_base_text_encoding_h
#define stickslip_base_text_encoding_h

#include <string>
#include <string_view>

namespace stickslip
{
  /// True if every byte belongs to a character of UTF-8.
  bool
  is_utf8(const std::string_view text);

  /// The same characters in UTF-8.
  std::string
  utf8_of_latin1(const std::string_view text);

  /// True if the byte order mark of UTF-16 begins the text of a file.
  bool
  is_utf16(const std::string_view text);

  /// The text of a file without the mark that some editors put before UTF-8.
  std::string_view
  without_byte_order_mark(const std::string_view text);
} // namespace stickslip

#endif
