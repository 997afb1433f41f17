#include <stickslip/base/text_encoding.h>

namespace stickslip
{
  bool
  is_utf8(const std::string_view text)
  {
    for (std::size_t i = 0; i < text.size();)
      {
        const unsigned char first    = text[i];
        const unsigned int  n_others = first < 0x80                    ? 0
                                       : first >= 0xC2 && first < 0xE0 ? 1
                                       : first >= 0xE0 && first < 0xF0 ? 2
                                       : first >= 0xF0 && first < 0xF5 ? 3
                                                                       : 4;
        if (n_others == 4 || i + n_others >= text.size() + (n_others == 0))
          return false;
        for (unsigned int k = 1; k <= n_others; ++k)
          if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80)
            return false;
        i += n_others + 1;
      }
    return true;
  }



  std::string
  utf8_of_latin1(const std::string_view text)
  {
    std::string result;
    for (const char letter : text)
      {
        const unsigned char code = letter;
        if (code < 0x80)
          result += letter;
        else
          {
            result += static_cast<char>(0xC0 | (code >> 6));
            result += static_cast<char>(0x80 | (code & 0x3F));
          }
      }
    return result;
  }



  bool
  is_utf16(const std::string_view text)
  {
    return text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF";
  }



  std::string_view
  without_byte_order_mark(const std::string_view text)
  {
    return text.substr(text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
  }
} // namespace stickslip
